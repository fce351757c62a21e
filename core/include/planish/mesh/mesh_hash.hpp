// SPDX-License-Identifier: MIT
/// A mesh's fingerprint.
#pragma once

#include <cstdint>
#include <string>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// CRC-32 of positions (float64), face offsets and face vertices (int32), all little endian.
[[nodiscard]] std::uint32_t mesh_hash(const Mesh& mesh);

/// Eight hexadecimal digits.
[[nodiscard]] std::string hash_text(std::uint32_t hash);

}  // namespace planish
