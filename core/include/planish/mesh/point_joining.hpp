// SPDX-License-Identifier: MIT
/// Panels that were written with points of their own, joined where these lie at one place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

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

/// "39 vertices were joined with another one at the same place, up to 1e-07 away".
[[nodiscard]] std::string joined_text(const JoinedPoints& joined);

/// `mesh` with these points. Faces may name a corner twice then: repair_and_check() mends it.
[[nodiscard]] Mesh with_joined_points(Mesh mesh, const JoinedPoints& joined);

/// `within`, but at most a tenth of the shortest side that is longer than it: no such side is lost.
[[nodiscard]] double safe_joining(const Mesh& mesh, double within);

/// A millionth of the size of `mesh`, as safe_joining() allows: what is told apart by less differs
/// by rounding alone.
[[nodiscard]] double usual_joining(const Mesh& mesh);

/// `mesh` with its points joined within `within` (model units; by default usual_joining()), and a
/// warning that counts them. Refused: no distance, one of half the shortest side or more, and where
/// joining gives no mesh, as check_mesh() says it.
[[nodiscard]] ReadResult join_points(const Mesh& mesh, std::optional<double> within = {});

}  // namespace planish
