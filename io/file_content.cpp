// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_content.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <new>
#include <system_error>

namespace tapeline {

Result<std::size_t> regular_file_size(const std::filesystem::path& path)
{
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) {
        return fail(ErrorKind::unreadable, fmt::format("cannot read {}: there is no such file", path.string()));
    }
    if (!error && status.type() == std::filesystem::file_type::directory) {
        return fail(ErrorKind::unreadable, fmt::format("cannot read {}: it is a folder, name a file", path.string()));
    }
    if (!error && status.type() != std::filesystem::file_type::regular) {
        return fail(ErrorKind::unreadable, fmt::format("cannot read {}: it is not a regular file", path.string()));
    }
    const auto size = error ? 0 : std::filesystem::file_size(path, error);
    if (error) {
        return fail(ErrorKind::unreadable, fmt::format("cannot read {}: {}", path.string(), error.message()));
    }
    return static_cast<std::size_t>(size);
}

Result<FileContent> read_file_content(const std::filesystem::path& path, std::size_t limit)
{
    const auto size = regular_file_size(path);
    if (!size) {
        return tl::unexpected(size.error());
    }
    const std::size_t wanted = std::min(*size, limit);
    try {
        auto bytes = std::make_unique_for_overwrite<char[]>(wanted + 1);
        std::ifstream file(path, std::ios::binary);
        file.read(bytes.get(), static_cast<std::streamsize>(wanted));
        if (!file) {
            return fail(ErrorKind::unreadable,
                        fmt::format("cannot read {}: check that you may open it and that it is not being written",
                                    path.string()));
        }
        return FileContent(std::move(bytes), wanted);
    } catch (const std::bad_alloc&) {
        return fail(ErrorKind::unreadable,
                    fmt::format("cannot read {}: its {} bytes do not fit into memory", path.string(), wanted));
    }
}

} // namespace tapeline
