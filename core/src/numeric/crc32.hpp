// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace planish {

/// The CRC-32 of zip and PNG; `seed` is the value for the bytes before, to go on from there.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes, std::uint32_t seed = 0);

}  // namespace planish
