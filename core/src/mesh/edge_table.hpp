// SPDX-License-Identifier: MIT
/// Every use of every edge by a face, grouped by edge: what validation and counting walk over.
#pragma once

#include <span>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// One side of one face. `corner` and `next_corner` are positions in Mesh::face_vertices.
struct EdgeUse {
  int low = 0, high = 0;            ///< the edge's vertices, low < high
  int corner = 0, next_corner = 0;  ///< the side runs from corner to next_corner
  int face = 0;
  bool forward = false;  ///< the face runs from low to high
};

/// All sides of all faces, sorted by edge and then by face. O(n log n) at worst.
[[nodiscard]] std::vector<EdgeUse> edge_uses(const Mesh& mesh);

/// The uses of each edge. @param uses sorted by edge, kept by the caller
[[nodiscard]] std::vector<std::span<const EdgeUse>> by_edge(const std::vector<EdgeUse>& uses);

}  // namespace planish
