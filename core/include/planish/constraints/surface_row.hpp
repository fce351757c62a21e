// SPDX-License-Identifier: MIT
/// The equation of a point that stands on a surface. No kind of constraint: supports of an edit
/// have such rows, a mesh has none. [SUP-4]
#pragma once

#include <Eigen/Core>
#include <array>

#include "planish/constraints/kind.hpp"

namespace planish {

/// How far a point is above a surface, as seen from where it was last:
///   c(p) = h + n · (p − q) + ½ (p − q)ᵀ S (p − q) = 0
/// The second order is what decides where flat panels leave all of them on a surface next to no way
/// to move: the multiplier times the curvature.
struct SurfaceRow {
  static constexpr int kArity = 1;
  static constexpr bool kCurvedDiagonal = true;
  std::array<int, 1> vertices{};
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< q
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< n, of length 1 or about
  Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();     ///< S, symmetric, 1 / length
  double height = 0.0;                                ///< h: beyond what it has in the base
};

/// SurfaceRow's place among ConstraintRows.
struct SurfacePoint {
  using Row = SurfaceRow;
};

[[nodiscard]] inline double residual(const SurfaceRow& row, const RowPoints<1>& points) {
  const Eigen::Vector3d way = points - row.centre;
  return row.height + (row.normal + 0.5 * (row.bend * way)).dot(way);
}

[[nodiscard]] inline RowPoints<1> gradient(const SurfaceRow& row, const RowPoints<1>& points) {
  return row.normal + row.bend * (points - row.centre);
}

[[nodiscard]] inline CurvatureBlocks<1, true> hessian(const SurfaceRow& row,
                                                      const RowPoints<1>& /*points*/) {
  return {row.bend};
}

}  // namespace planish
