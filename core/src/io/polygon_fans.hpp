// SPDX-License-Identifier: MIT
/// Polygons as runs of triangles, the way our GLB files hold them, and back.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Each face as a fan around one of its vertices, 3 indices a triangle, faces in order. A fan
/// never starts at the vertex that the fan before it started at (the order of FB_ngon_encoding),
/// and starts where a concave face's triangles do not overlap, if there is such a vertex.
[[nodiscard]] std::vector<int> encode_fans(const Mesh& mesh);

struct FaceList {
  std::vector<int> offsets{0};
  std::vector<int> vertices;
};

/// The faces of `sizes` from consecutive fans; nullopt if the triangles are not such fans.
[[nodiscard]] std::optional<FaceList> decode_fans(std::span<const int> triangles,
                                                  std::span<const int> sizes);

/// Joins neighbouring triangles that lie in one plane (to 0.1 mm/m), in the order of each face's
/// first triangle; nullopt unless that gives exactly the faces counted in `sizes`.
[[nodiscard]] std::optional<FaceList> merge_coplanar(const Positions& positions,
                                                     std::span<const int> triangles,
                                                     std::span<const int> sizes);

/// Whether both lists hold the same faces in the same order, each from whichever vertex.
[[nodiscard]] bool same_up_to_rotation(const FaceList& a, const FaceList& b);

}  // namespace planish
