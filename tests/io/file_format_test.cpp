// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_format.h"
#include "io/model_file.h"

#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>

using namespace tapeline;

namespace {

std::string binary_stl(unsigned count, std::string header = {})
{
    header.resize(80, ' ');
    for (int k = 0; k < 4; ++k) {
        header += static_cast<char>(count >> (8 * k) & 255);
    }
    return header + std::string(50 * std::size_t(count), '\0');
}

FileFormat sniff(const std::string& text, const std::string& ending = {})
{
    return sniff_format(text, text.size(), ending);
}

} // namespace

TEST(FileFormat, IsToldFromTheContentWhateverTheName)
{
    const std::string iges_start = fmt::format("{:72}S0000001\r\n", "");
    for (const std::string ending : {"", ".stl", ".obj", ".step"}) {
        EXPECT_EQ(sniff("ISO-10303-21;\nHEADER;", ending), FileFormat::step);
        EXPECT_EQ(sniff("\xEF\xBB\xBF /* a */\n/* b */ ISO-10303-21;", ending), FileFormat::step);
        EXPECT_EQ(sniff(iges_start, ending), FileFormat::iges);
        EXPECT_EQ(sniff("DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\n", ending),
                  FileFormat::brep);
        EXPECT_EQ(sniff("\nOpen CASCADE Topology V4 (c)\n", ending), FileFormat::brep_binary);
        EXPECT_EQ(sniff("ply\rformat ascii 1.0\r", ending), FileFormat::ply_ascii);
        EXPECT_EQ(sniff("ply\r\ncomment x\r\nformat binary_big_endian 1.0\r\n", ending), FileFormat::ply_binary_big);
        EXPECT_EQ(sniff("ply\nformat binary_little_endian 1.0\n", ending), FileFormat::ply_binary_little);
        EXPECT_EQ(sniff("STCN4nOFF\n3 1 0\n", ending), FileFormat::off);
        EXPECT_EQ(sniff("OFF BINARY\n", ending), FileFormat::off_binary);
        EXPECT_EQ(sniff("solid x\nfacet normal 0 0 1\n", ending), FileFormat::stl_ascii);
        EXPECT_EQ(sniff("", ending), FileFormat::empty);
        EXPECT_EQ(sniff(" \r\n\t\n", ending), FileFormat::empty);
    }
    EXPECT_EQ(sniff("# a\n\n  v 1 2 3\n"), FileFormat::obj);
    EXPECT_EQ(sniff("hello world, this is a letter"), FileFormat::unknown);
}

TEST(FileFormat, CallsAnStlBinaryByItsSizeEvenWhenItStartsWithSolid)
{
    EXPECT_EQ(sniff(binary_stl(2, "solid exported by CAD")), FileFormat::stl_binary);
    EXPECT_EQ(sniff(binary_stl(2, "anything")), FileFormat::stl_binary);
    EXPECT_EQ(sniff(binary_stl(3, "solid cut off").substr(0, 100)), FileFormat::stl_binary);
}

TEST(FileFormat, UsesTheEndingOnlyWhereTheBytesLeaveItOpen)
{
    EXPECT_EQ(sniff("3 1 0\n0 0 0\n", ".OFF"), FileFormat::off);
    EXPECT_EQ(sniff("call other.obj\n", ".obj"), FileFormat::obj);
    EXPECT_EQ(sniff(binary_stl(3).substr(0, 100), ".STL"), FileFormat::stl_binary);
    EXPECT_EQ(sniff(binary_stl(3).substr(0, 100), ".dat"), FileFormat::unknown);
}

TEST(FileFormat, OfEveryModelFromElsewhereMatchesItsEnding)
{
    const char* data = std::getenv("TAPELINE_DATA");
    if (!data) {
        GTEST_SKIP() << "TAPELINE_DATA is not set";
    }
    const auto models = std::filesystem::path(data) / "models";
    EXPECT_EQ(file_format(models / "rook.stl").value(), FileFormat::stl_ascii);
    EXPECT_EQ(file_format(models / "featuretype.STL").value(), FileFormat::stl_binary);
    EXPECT_EQ(file_format(models / "fandisk_pmp.off").value(), FileFormat::off);
    EXPECT_EQ(file_format(models / "hammer.brep").value(), FileFormat::brep);
    for (const auto name : {"hammer.iges", "D150_wing.igs"}) {
        EXPECT_EQ(file_format(models / name).value(), FileFormat::iges);
    }
    for (const auto& entry : std::filesystem::directory_iterator(models)) {
        const auto ending = entry.path().extension();
        if (ending == ".step" || ending == ".stp" || ending == ".STEP") {
            EXPECT_EQ(file_format(entry).value(), FileFormat::step) << entry;
            EXPECT_TRUE(is_cad_file(entry));
        }
    }
}

TEST(FileFormat, RefusesWhatCannotBeReadInOneSentence)
{
    const auto folder = file_format(std::filesystem::temp_directory_path());
    ASSERT_FALSE(folder);
    EXPECT_NE(folder.error().message.find("is a folder"), std::string::npos);
    const auto missing = file_format("/no/such/file.stl");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::unreadable);
    EXPECT_NE(missing.error().message.find("no such file"), std::string::npos);
    EXPECT_FALSE(is_cad_file("/no/such/file.step"));
}
