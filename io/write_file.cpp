// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_file.h"

#include <fmt/format.h>
#include <fstream>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace tapeline {

Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view content)
{
    std::filesystem::path temporary = path;
    temporary += fmt::format(".{}.part", getpid());
    std::error_code error;
    {
        std::ofstream file(temporary, std::ios::binary);
        file.write(content.data(), static_cast<std::streamsize>(content.size()));
        file.close();
        if (!file) {
            std::filesystem::remove(temporary, error);
            return fail(
                ErrorKind::unreadable,
                fmt::format("cannot write {}: check that the folder exists, is writable and has room", path.string()));
        }
    }
    std::filesystem::rename(temporary, path, error);
    if (error) {
        const std::string reason = error.message();
        std::filesystem::remove(temporary, error);
        return fail(ErrorKind::unreadable, fmt::format("cannot write {}: {}", path.string(), reason));
    }
    return {};
}

} // namespace tapeline
