// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

namespace tapeline {

/// The bytes of one file, read in one go. Not memory-mapped: a mapped file that another program shortens meanwhile
/// would end the process.
class FileContent {
public:
    FileContent() = default;
    FileContent(std::unique_ptr<char[]> bytes, std::size_t size) : bytes_(std::move(bytes)), size_(size) {}

    std::string_view view() const { return {bytes_.get(), size_}; }

private:
    std::unique_ptr<char[]> bytes_;
    std::size_t size_ = 0;
};

/// Reads a regular file completely, or its first `limit` bytes. Fails with ErrorKind::unreadable where the file is
/// not there, is a folder or a device, cannot be opened, or does not fit into memory; an empty file is no failure.
Result<FileContent> read_file_content(const std::filesystem::path& path,
                                      std::size_t limit = static_cast<std::size_t>(-1));

/// Size of a regular file [bytes]; fails like `read_file_content`.
Result<std::size_t> regular_file_size(const std::filesystem::path& path);

} // namespace tapeline
