// SPDX-License-Identifier: MIT
/// Panels that were written with points of their own, joined where these lie at one place.
#pragma once

#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Which points become one.
struct JoinedPoints {
  std::vector<int> target;  ///< of each point: its number afterwards
  std::vector<int> kept;    ///< of each number afterwards: the point that it was, ascending
  double largest = 0.0;     ///< the farthest that a point goes, model units

  [[nodiscard]] std::size_t joined() const { return target.size() - kept.size(); }
};

/// Each point takes the place of the nearest kept one within `within` (model units; 0: the same
/// place only), and is kept where there is none. Points that are not finite stay. O(n log n).
[[nodiscard]] JoinedPoints find_joined_points(const Positions& positions, double within);

/// `mesh` with these points. Faces may name a corner twice then: repair_and_check() mends it.
[[nodiscard]] Mesh with_joined_points(Mesh mesh, const JoinedPoints& joined);

/// `within`, but at most a tenth of the shortest side that is longer than it: no such side is lost.
[[nodiscard]] double safe_joining(const Mesh& mesh, double within);

}  // namespace planish
