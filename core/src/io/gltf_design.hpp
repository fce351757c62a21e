// SPDX-License-Identifier: MIT
/// The exact float64 design that rides along in a GLB's asset.extras, as base64 text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/polygon_fans.hpp"
#include "io/tinygltf_api.hpp"
#include "planish/io/gltf.hpp"

namespace planish {

/// Names the node of GlbContent::offset, and marks its mesh in `extras`: it is no part of the
/// design.
inline constexpr const char* kOffsetLayer = "planish offset";

struct StoredDesign {
  Positions positions;
  FaceList faces;
  std::vector<FaceGroup> groups;
  std::optional<Positions> base;
  std::string design;
};

/// `value` as an int; nullopt if it is no number, not whole or too large, on which
/// tinygltf's own GetNumberAsInt() is undefined.
[[nodiscard]] std::optional<int> whole_number(const tinygltf::Value& value);

[[nodiscard]] tinygltf::Value store_design(const Mesh& mesh, const GlbContent& content);

/// nullopt if `extras` holds none, or a damaged one; indices are checked against the positions.
[[nodiscard]] std::optional<StoredDesign> load_design(const tinygltf::Value& extras);

}  // namespace planish
