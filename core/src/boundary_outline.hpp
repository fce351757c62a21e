// SPDX-License-Identifier: MIT
/// The polygon that a mesh's boundary is drawn as. [SUP-3]
#pragma once

#include <vector>

#include "planish/adjacency.hpp"
#include "planish/mesh.hpp"

namespace planish {

/// Who comes before and after a vertex on its boundary; O(n) once.
class BoundaryOutline {
 public:
  /// A turn of the outline, in degrees, from which on a vertex is a corner that no point passes.
  static constexpr double kSharpTurn = 30.0;

  explicit BoundaryOutline(const Mesh& mesh);

  /// The vertex after `vertex` where `side` is 1, before it where it is 0; −1 where the boundary
  /// ends or branches there.
  [[nodiscard]] int beside(int vertex, int side) const;
  /// Whether the outline turns sharply at `vertex`, ends or branches.
  [[nodiscard]] bool is_corner(int vertex) const;

 private:
  const Mesh& mesh_;
  std::vector<int> before_, after_;  ///< n; −1 where there is none
};

}  // namespace planish
