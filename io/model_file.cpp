// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model_file.h"

#include "io/file_format.h"

namespace tapeline {

Result<ImportedModel> read_model(const std::filesystem::path& path, const ImportOptions& options)
{
    const auto format = readable_file_format(path);
    if (!format) {
        return tl::unexpected(format.error());
    }
    return is_cad_format(*format) ? read_cad(path, options) : read_mesh(path, options);
}

} // namespace tapeline
