// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/target_file.h"

#include "io/file_content.h"
#include "io/model_file.h"
#include "io/target_formats.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace tapeline {

namespace {

std::string ending_of(const std::filesystem::path& path)
{
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

/// First character of the text proper, 0 when there is none.
char first_character(std::string_view content)
{
    content.remove_prefix(content.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    const size_t at = content.find_first_not_of(" \t\r\n\v\f");
    return at == std::string_view::npos ? '\0' : content[at];
}

Result<std::string> encode(const std::filesystem::path& path, const TargetLine& line)
{
    const std::string ending = ending_of(path);
    if (ending == ".json" || ending.empty()) {
        return target_to_json(line);
    }
    if (ending == ".csv") {
        return target_to_csv(line);
    }
    if (ending == ".step" || ending == ".stp" || ending == ".p21") {
        return target_to_cad(line, FileFormat::step);
    }
    if (ending == ".iges" || ending == ".igs") {
        return target_to_cad(line, FileFormat::iges);
    }
    if (ending == ".brep" || ending == ".brp") {
        return target_to_cad(line, FileFormat::brep);
    }
    return fail(ErrorKind::usage, fmt::format("{}: a target line is written as .json, .step, .iges, .brep or .csv, not "
                                              "as {}",
                                              path.string(), ending));
}

} // namespace

Result<TargetLine> read_target(const std::filesystem::path& path)
try {
    const auto content = read_file_content(path);
    if (!content) {
        return tl::unexpected(content.error());
    }
    const std::string file = path.string();
    const FileFormat format = sniff_format(content->view().substr(0, 65536), content->view().size(), ending_of(path));
    if (is_cad_format(format)) {
        return target_from_cad(path, format);
    }
    if (format == FileFormat::empty) {
        return fail(ErrorKind::unreadable, fmt::format("{} is empty: it holds no target line", file));
    }
    if (format == FileFormat::utf16) {
        return fail(ErrorKind::unreadable, fmt::format("{} is UTF-16 text: save it as UTF-8", file));
    }
    return first_character(content->view()) == '{' ? target_from_json(file, content->view())
                                                   : target_from_csv(file, content->view());
} catch (const std::exception& exception) {
    return fail(ErrorKind::unreadable, fmt::format("{} cannot be read: {}", path.string(), exception.what()));
}

Result<void> write_target(const std::filesystem::path& path, const TargetLine& line)
try {
    return encode(path, line).and_then([&](const std::string& bytes) { return write_file_atomically(path, bytes); });
} catch (const std::exception& exception) {
    return fail(ErrorKind::unreadable, fmt::format("{} cannot be written: {}", path.string(), exception.what()));
}

Result<std::vector<ControlPointEdit>> read_edits(const std::filesystem::path& path)
try {
    return read_file_content(path).and_then(
        [&](const FileContent& content) { return edits_from_json(path.string(), content.view()); });
} catch (const std::exception& exception) {
    return fail(ErrorKind::unreadable, fmt::format("{} cannot be read: {}", path.string(), exception.what()));
}

} // namespace tapeline
