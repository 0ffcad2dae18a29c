// SPDX-License-Identifier: GPL-3.0-or-later
// Who may include whom: kernel <- bspline <- io <- plugin.
#include "tests/plugin/run_command.h"

#include <array>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace tapeline::testing {
namespace {

namespace fs = std::filesystem;

struct Source {
    std::string name;                  ///< relative to the repository
    std::string folder;                ///< "kernel", "bspline", "io" or "plugin"
    std::vector<std::string> includes; ///< without quotes or brackets
};

/// All sources of the library and the program.
std::vector<Source> sources()
{
    std::vector<Source> found;
    const fs::path root = TAPELINE_SOURCE_DIR;
    for (const std::string folder : {"kernel", "bspline", "io", "plugin"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") {
                continue;
            }
            Source source{entry.path().lexically_relative(root).string(), folder, {}};
            std::istringstream text(read_text(entry.path()));
            for (std::string line; std::getline(text, line);) {
                if (line.starts_with("#include") && line.size() > 11) {
                    source.includes.push_back(line.substr(10, line.find_first_of("\">", 10) - 10));
                }
            }
            found.push_back(source);
        }
    }
    return found;
}

/// OpenCASCADE headers: Name_Name.hxx, gp_Pnt.hxx, Standard.hxx, ….
bool is_occt(const std::string& include) { return include.ends_with(".hxx"); }
bool is_cgal(const std::string& include) { return include.starts_with("CGAL/"); }

TEST(Includes, PointOnlyInwards)
{
    const std::map<std::string, int> rank = {{"kernel", 0}, {"bspline", 1}, {"io", 2}, {"plugin", 3}};
    int checked = 0;
    for (const Source& source : sources()) {
        for (const std::string& include : source.includes) {
            const auto other = rank.find(include.substr(0, include.find('/')));
            if (other != rank.end()) {
                EXPECT_LE(other->second, rank.at(source.folder)) << source.name << " includes " << include;
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 100);
}

TEST(Includes, KeepOpenCascadeInSourcesOfBsplineAndIo)
{
    for (const Source& source : sources()) {
        for (const std::string& include : source.includes) {
            if (is_occt(include)) {
                EXPECT_TRUE(source.folder == "bspline" || source.folder == "io") << source.name;
            }
            if (is_cgal(include)) {
                EXPECT_EQ(source.folder, "kernel") << source.name;
            }
        }
    }
}

/// Everything of ours that a file pulls in, itself included.
void collect(const std::string& name, const std::map<std::string, Source>& all, std::map<std::string, bool>& seen)
{
    const auto source = all.find(name);
    if (source == all.end() || !seen.emplace(name, true).second) {
        return;
    }
    for (const std::string& include : source->second.includes) {
        collect(include, all, seen);
    }
}

TEST(Includes, NeverBringOpenCascadeAndCgalTogether)
{
    std::map<std::string, Source> all;
    for (const Source& source : sources()) {
        all[source.name] = source;
    }
    for (const auto& [name, source] : all) {
        std::map<std::string, bool> seen;
        collect(name, all, seen);
        bool occt = false, cgal = false;
        for (const auto& [file, unused] : seen) {
            for (const std::string& include : all[file].includes) {
                occt = occt || is_occt(include);
                cgal = cgal || is_cgal(include);
            }
        }
        EXPECT_FALSE(occt && cgal) << name;
    }
}

TEST(Includes, LeaveTheKernelWithoutFilesAndPrinting)
{
    for (const Source& source : sources()) {
        for (const std::string& include : source.includes) {
            if (source.folder == "kernel") {
                for (const std::string banned : {"fstream", "iostream", "cstdio", "filesystem", "spdlog"}) {
                    EXPECT_FALSE(include.starts_with(banned)) << source.name << " includes " << include;
                }
            }
        }
    }
}

TEST(Sources, SayTheirLicenceFirst)
{
    for (const Source& source : sources()) {
        EXPECT_TRUE(read_text(fs::path(TAPELINE_SOURCE_DIR) / source.name)
                        .starts_with("// SPDX-License-Identifier: GPL-3.0-or-later\n"))
            << source.name;
    }
}

} // namespace
} // namespace tapeline::testing
