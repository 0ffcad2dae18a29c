// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/sha256.h"

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <openssl/evp.h>

namespace tapeline {

Result<std::string> file_sha256(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
    bool fine = file.good() && digest && EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr) == 1;
    std::array<char, 1 << 16> block{};
    while (fine && file) {
        file.read(block.data(), block.size());
        fine = EVP_DigestUpdate(digest.get(), block.data(), static_cast<std::size_t>(file.gcount())) == 1;
    }
    std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
    unsigned size = 0;
    if (!fine || file.bad() || EVP_DigestFinal_ex(digest.get(), sum.data(), &size) != 1) {
        return fail(ErrorKind::unreadable, fmt::format("cannot read {} to take its checksum", path.string()));
    }
    std::string text;
    for (unsigned k = 0; k < size; ++k) {
        text += fmt::format("{:02x}", sum[k]);
    }
    return text;
}

} // namespace tapeline
