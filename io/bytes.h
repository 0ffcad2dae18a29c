// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace tapeline {

enum class Endian { little, big };

/// The number that starts at `bytes`, stored in the given order; sizeof(T) bytes must be there, any alignment.
template <class T>
T load(const char* bytes, Endian order)
{
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes, sizeof(T));
    if ((order == Endian::little) != (std::endian::native == std::endian::little)) {
        std::ranges::reverse(raw);
    }
    return std::bit_cast<T>(raw);
}

/// Appends a number's bytes in the given order.
template <class T>
void store(std::string& out, T value, Endian order)
{
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if ((order == Endian::little) != (std::endian::native == std::endian::little)) {
        std::ranges::reverse(raw);
    }
    out.append(raw.data(), raw.size());
}

} // namespace tapeline
