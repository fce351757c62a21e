// SPDX-License-Identifier: MIT
/// What the header of a PLY file declares.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "planish/io/ply.hpp"

namespace planish {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

/// Bytes of one value.
[[nodiscard]] std::size_t ply_size(PlyType type);
[[nodiscard]] bool is_whole(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;
  std::optional<PlyType> count_type;  ///< set for lists
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  ///< as claimed
  std::vector<PlyProperty> properties;
  int line = 0;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::string_view body;  ///< what follows end_header
  int body_line = 1;
  std::vector<std::string> warnings;
};

/// The header, or a sentence that names the line.
[[nodiscard]] std::variant<PlyHeader, std::string> read_ply_header(std::string_view bytes);

}  // namespace planish
