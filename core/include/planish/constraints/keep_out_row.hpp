// SPDX-License-Identifier: MIT
/// The rows of keep-outs: a point stays on the free side of a plane. g = n · p. [KEE-1]
///
/// A box has a plane for every panel, between the two: every point of the panel stays on its side
/// of it. MeshKeepOuts::choose_planes() takes another where the panel has turned. [KEE-3]
///
/// A point that is on the plane or beyond it in the base has no room for a barrier: it rests there.
/// Its share is 0 where it is, an edit lets it go along the plane and away (see VertexSlides), and
/// a search finds which by a spring in place of the barrier. [KEE-2]
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "planish/constraints/limit_kind.hpp"
#include "planish/constraints/limit_scale.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/obstacles/keep_out.hpp"

namespace planish {

struct KeepOutRow {
  static constexpr int kArity = 1;
  std::array<int, 1> vertices{};
  LimitScale scale;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  bool rests = false;  ///< on the plane or beyond it in the base
  int panel = -1;      ///< that stays out of a box; −1: the row is no box's
  int box = -1;

  /// The share of the point at `place`: 1/2 or more where no force acts, 0 at the bound.
  [[nodiscard]] double share(const Eigen::Vector3d& place) const {
    return scale.share(normal.dot(place));
  }
  [[nodiscard]] int vertex() const { return vertices[0]; }
};

[[nodiscard]] inline double value(const KeepOutRow& row, const RowPoints<1>& points) {
  return row.normal.dot(points.col(0));
}
[[nodiscard]] inline RowPoints<1> gradient(const KeepOutRow& row, const RowPoints<1>& /*points*/) {
  return row.normal;
}
[[nodiscard]] inline LimitHessian<1> hessian(const KeepOutRow& /*row*/,
                                             const RowPoints<1>& /*points*/) {
  return LimitHessian<1>::Zero();
}
static_assert(LimitRow<KeepOutRow>);

/// A plane that has a box on one side: n · p < h inside it, clearance included.
struct BoxPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double bound = 0.0;
  double gap =
      0.0;  ///< from it to the nearest point of the panel; negative: no plane separates them
};

/// `box` in the unit and the place of `base.points`.
[[nodiscard]] KeptBox in_points(const LimitBase& base, const KeptBox& box);

/// The plane with the widest gap among those at right angles to a side of the box, to the panel, or
/// to an edge of either. @param panel 3 × corners
[[nodiscard]] BoxPlane widest_plane(const KeptBox& box, const Positions& panel);

/// The row of a panel's point for a plane that the base may not have.
/// @param place in the base; @param side a length of the panel
/// @param bound of normal · p, unit of the points
[[nodiscard]] KeepOutRow plane_row(int vertex, const Eigen::Vector3d& place, double side,
                                   const Eigen::Vector3d& normal, double bound);

/// The row of a point for a plane of the base: where it has no room it rests.
/// @param room normal · p − bound of the point, unit of the points
[[nodiscard]] KeepOutRow base_row(const LimitBase& base, int vertex, double side,
                                  const Eigen::Vector3d& normal, double room);

/// How near a plane is to a point that rests on it, sides of its panel.
inline constexpr double kRestsWithin = 1e-3;

/// Mean length of a panel's sides; 1 where they have none.
[[nodiscard]] double mean_side(const Positions& points, std::span<const int> panel);

/// First those of half-spaces, of the points whose first panel is `face`; then those of boxes, box
/// by box, of all points of the panel.
void append_rows(const LimitBase& base, const FreeSpace& free, int face,
                 std::vector<KeepOutRow>& out);

}  // namespace planish
