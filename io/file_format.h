// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace tapeline {

/// What a model file's content is. Told from the bytes; the name's ending decides only where the bytes leave it open
/// (OBJ and headerless OFF have no signature, a damaged binary STL looks like anything).
enum class FileFormat {
    unknown,
    empty, ///< no bytes, or nothing but blanks
    utf16, ///< text in two-byte characters, whatever it says
    step,
    iges,
    brep,        ///< OpenCASCADE's text form
    brep_binary, ///< OpenCASCADE's BinTools form
    stl_ascii,
    stl_binary,
    obj,
    ply_ascii,
    ply_binary_little,
    ply_binary_big,
    off,
    off_binary
};

/// Name for people and for `ImportReport::format`: "STEP", "IGES", "BREP", "BREP binary", "STL ascii", "STL binary",
/// "OBJ", "PLY ascii", "PLY binary little-endian", "PLY binary big-endian", "OFF", "OFF binary", ….
std::string_view format_name(FileFormat format);

/// True for STEP, IGES and both kinds of BREP.
bool is_cad_format(FileFormat format);

/// How many of a file's first bytes `sniff_format` needs.
inline constexpr std::size_t sniffed_bytes = 65536;

/// Tells the format from a file's first `sniffed_bytes` (or all there are), its whole size [bytes] and its name's ending
/// (".stl", any case; may be empty). Never fails: `unknown` when nothing fits.
FileFormat sniff_format(std::string_view head, std::size_t file_size, std::string_view ending = {});

/// Tells the format of the file at `path`. Fails with ErrorKind::unreadable where the file cannot be opened.
Result<FileFormat> file_format(const std::filesystem::path& path);

/// The format itself, or one sentence about the file `name` where no reader exists for it: empty, UTF-16, binary OFF,
/// unknown.
Result<FileFormat> require_readable(std::string_view name, FileFormat format);

/// `file_format` and `require_readable` in one.
Result<FileFormat> readable_file_format(const std::filesystem::path& path);

} // namespace tapeline
