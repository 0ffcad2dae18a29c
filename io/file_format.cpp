// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_format.h"

#include "io/file_content.h"
#include "io/model_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fmt/format.h>
#include <string>

namespace tapeline {

namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

std::string lower(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// The first word of a text and what follows it on the same line.
struct Words {
    std::string_view first, second;
};
Words first_words(std::string_view text)
{
    const auto take = [&text] {
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
        const auto word = text.substr(0, text.find_first_of(blanks));
        text.remove_prefix(word.size());
        return word;
    };
    const auto first = take();
    return {first, take()};
}

/// The text after leading blanks and /* comments */, as STEP allows them.
std::string_view skip_step_comments(std::string_view text)
{
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        if (!text.starts_with("/*")) {
            return text;
        }
        const auto end = text.find("*/");
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    }
}

/// IGES: 80-column records; the first has an S in column 73 followed by the number 1.
bool looks_like_iges(std::string_view head)
{
    const auto line = head.substr(0, head.find_first_of("\r\n"));
    if (line.size() < 74 || line.size() > 100 || line[72] != 'S') {
        return false;
    }
    auto number = line.substr(73);
    number.remove_prefix(std::min(number.find_first_not_of(" 0"), number.size()));
    return number.substr(0, number.find_last_not_of(' ') + 1) == "1";
}

/// Number of triangles that a binary STL header announces, or -1 where the file is too short for one.
std::int64_t binary_stl_count(std::string_view head)
{
    if (head.size() < 84) {
        return -1;
    }
    std::int64_t count = 0;
    for (int k = 3; k >= 0; --k) {
        count = count * 256 + static_cast<unsigned char>(head[80 + k]);
    }
    return count;
}

/// No control characters but blanks: what a text file looks like in any 8-bit encoding.
bool looks_like_text(std::string_view head)
{
    return std::ranges::none_of(head, [](unsigned char c) {
        return c < 32 && blanks.find(static_cast<char>(c)) == std::string_view::npos && c != 26;
    });
}

FileFormat sniff_ply(std::string_view head)
{
    // The format line is the first after "ply" in every file seen, but comments before it are legal.
    std::size_t at = 3;
    for (int line = 0; line < 64; ++line) {
        at = head.find_first_not_of("\r\n", at);
        if (at == std::string_view::npos) {
            break;
        }
        const auto words = first_words(head.substr(at));
        if (words.first == "format") {
            return words.second == "binary_little_endian" ? FileFormat::ply_binary_little
                   : words.second == "binary_big_endian"  ? FileFormat::ply_binary_big
                                                          : FileFormat::ply_ascii;
        }
        at = std::min(head.find_first_of("\r\n", at), head.size());
    }
    return FileFormat::ply_ascii;
}

/// [ST][C][N][4][n]OFF, geomview's family of keywords.
bool is_off_keyword(std::string_view word)
{
    if (!word.ends_with("OFF")) {
        return false;
    }
    word.remove_suffix(3);
    for (const std::string_view prefix : {"ST", "C", "N", "4", "n"}) {
        if (word.starts_with(prefix)) {
            word.remove_prefix(prefix.size());
        }
    }
    return word.empty();
}

/// Reads like OBJ: the first line that is no comment starts with one of its keywords.
bool looks_like_obj(std::string_view text)
{
    constexpr std::array keywords{"v", "vn", "vt", "vp", "f", "o", "g", "s", "l", "p", "usemtl", "mtllib", "mg", "lod"};
    while (!text.empty()) {
        const auto words = first_words(text);
        if (!words.first.empty() && words.first[0] != '#') {
            return std::ranges::find(keywords, words.first) != keywords.end();
        }
        text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    }
    return false;
}

FileFormat sniff_stl(std::string_view head, std::size_t file_size, std::string_view text, std::string_view ending)
{
    const std::int64_t count = binary_stl_count(head);
    // Printable bytes at 80..83 would announce a file beyond 26 GB, so an exact fit is never a text file.
    if (count >= 0 && 84 + 50 * static_cast<std::uint64_t>(count) == file_size) {
        return FileFormat::stl_binary;
    }
    const bool named_stl = ending == ".stl";
    if (lower(text.substr(0, 5)) == "solid" && (text.size() == 5 || blanks.find(text[5]) != std::string_view::npos)) {
        return looks_like_text(text) ? FileFormat::stl_ascii : FileFormat::stl_binary;
    }
    return named_stl && !looks_like_text(head) ? FileFormat::stl_binary : FileFormat::unknown;
}

} // namespace

std::string_view format_name(FileFormat format)
{
    switch (format) {
    case FileFormat::unknown:
        return "unknown";
    case FileFormat::empty:
        return "empty";
    case FileFormat::utf16:
        return "UTF-16 text";
    case FileFormat::step:
        return "STEP";
    case FileFormat::iges:
        return "IGES";
    case FileFormat::brep:
        return "BREP";
    case FileFormat::brep_binary:
        return "BREP binary";
    case FileFormat::stl_ascii:
        return "STL ascii";
    case FileFormat::stl_binary:
        return "STL binary";
    case FileFormat::obj:
        return "OBJ";
    case FileFormat::ply_ascii:
        return "PLY ascii";
    case FileFormat::ply_binary_little:
        return "PLY binary little-endian";
    case FileFormat::ply_binary_big:
        return "PLY binary big-endian";
    case FileFormat::off:
        return "OFF";
    case FileFormat::off_binary:
        return "OFF binary";
    }
    return "unknown";
}

bool is_cad_format(FileFormat format)
{
    return format == FileFormat::step || format == FileFormat::iges || format == FileFormat::brep ||
           format == FileFormat::brep_binary;
}

FileFormat sniff_format(std::string_view head, std::size_t file_size, std::string_view name_ending)
{
    const std::string ending = lower(name_ending);
    if (head.starts_with("\xFE\xFF") || head.starts_with("\xFF\xFE")) {
        return FileFormat::utf16;
    }
    std::string_view text = head;
    if (text.starts_with("\xEF\xBB\xBF")) {
        text.remove_prefix(3);
    }
    if (looks_like_iges(text)) {
        return FileFormat::iges;
    }
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    if (text.empty() && file_size <= head.size()) {
        return FileFormat::empty;
    }
    if (skip_step_comments(text).starts_with("ISO-10303-21")) {
        return FileFormat::step;
    }
    const auto start = text.substr(0, 512);
    if (const auto at = start.find("CASCADE Topology V"); at != std::string_view::npos) {
        return at >= 5 && start.substr(at - 5, 5) == "Open " ? FileFormat::brep_binary : FileFormat::brep;
    }
    const auto words = first_words(text);
    if (words.first == "ply") {
        return sniff_ply(text);
    }
    if (is_off_keyword(words.first)) {
        return words.second == "BINARY" ? FileFormat::off_binary : FileFormat::off;
    }
    if (const auto stl = sniff_stl(head, file_size, text, ending); stl != FileFormat::unknown) {
        return stl;
    }
    if (looks_like_text(text)) {
        if (ending == ".off") {
            return FileFormat::off;
        }
        if (ending == ".obj" || looks_like_obj(text)) {
            return FileFormat::obj;
        }
    }
    return FileFormat::unknown;
}

Result<FileFormat> file_format(const std::filesystem::path& path)
{
    const auto size = regular_file_size(path);
    if (!size) {
        return tl::unexpected(size.error());
    }
    const auto head = read_file_content(path, sniffed_bytes);
    if (!head) {
        return tl::unexpected(head.error());
    }
    return sniff_format(head->view(), *size, path.extension().string());
}

Result<FileFormat> require_readable(std::string_view name, FileFormat format)
{
    switch (format) {
    case FileFormat::empty:
        return fail(ErrorKind::unreadable, fmt::format("{} is empty: export the model again", name));
    case FileFormat::utf16:
        return fail(ErrorKind::unreadable,
                    fmt::format("{} is UTF-16 text, which no model format uses: save it as UTF-8 or ASCII", name));
    case FileFormat::off_binary:
        return fail(
            ErrorKind::unreadable,
            fmt::format("{} is a binary OFF file, which is not supported: save it as text OFF or as PLY", name));
    case FileFormat::unknown:
        return fail(ErrorKind::unreadable,
                    fmt::format("{} is none of STEP, IGES, BREP, STL, OBJ, PLY, OFF by its content: check that it is a "
                                "model file and complete",
                                name));
    default:
        return format;
    }
}

Result<FileFormat> readable_file_format(const std::filesystem::path& path)
{
    const auto format = file_format(path);
    return format ? require_readable(path.string(), *format) : format;
}

bool is_cad_file(const std::filesystem::path& path)
{
    const auto format = file_format(path);
    return format && is_cad_format(*format);
}

} // namespace tapeline
