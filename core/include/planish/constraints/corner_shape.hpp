// SPDX-License-Identifier: MIT
/// The bound that keeps a panel's shape: no corner loses its side. [SHP-1]
///
/// With n⁰ the unit area vector of the panel in the base mesh and (a, b, c) = (previous, this,
/// next) corner,
///
///   g(p) = n⁰ · ((b − a) × (c − b)),   s = (g / g⁰ − κ) / (1 − κ) ≥ 0
///
/// where g⁰ is the value in the base: the bound is relative, so the base always keeps it, and a
/// reflex corner stays reflex. A corner that is straight in the base has no side to keep; it may
/// turn inwards by kStraightTurn: s = 1 + g / (‖b − a‖ ‖c − b‖ kStraightTurn), lengths of the base.
/// One row rules out concave, turned-over and collapsed panels alike. Its price: a panel cannot
/// turn by nearly 90°. Where a corner of a panel with more than four is reflex, the triangles
/// between its corners have such rows too: they keep it from going through a side.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "planish/constraints/kind.hpp"
#include "planish/constraints/limit_scale.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Sine of a turn below which a corner of the base is straight.
inline constexpr double kStraight = 1e-3;
/// Sine of the turn, one degree, by which a straight corner may become reflex.
inline constexpr double kStraightTurn = 0.0174524064372835;

/// A bound's row, in the form of the constraints' rows: residual() is s, at least zero.
struct CornerShape {
  static constexpr int kArity = 3;
  static constexpr LimitScale scale{1.0, 0.0};  ///< g is the share itself
  static constexpr bool kCurvedDiagonal = false;
  std::array<int, 3> vertices{};  ///< previous, this, next
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero();  ///< n⁰ scaled: s = normal · (in × out) + offset
  double offset = 0.0;
};

/// Whether the corner is straight in the base: no share of a side is kept, but a turn is let in.
[[nodiscard]] inline bool is_straight(const CornerShape& corner) { return corner.offset > 0.0; }

/// s: 1 in the base mesh, 0 at the bound.
[[nodiscard]] double residual(const CornerShape& corner, const RowPoints<3>& points);
[[nodiscard]] inline double value(const CornerShape& corner, const RowPoints<3>& points) {
  return residual(corner, points);
}

/// ∂s/∂(vertex k) in column k. [SHP-2]
[[nodiscard]] RowPoints<3> gradient(const CornerShape& corner, const RowPoints<3>& points);

/// ∂²s: skew blocks (1,0) (2,0) (2,1), whatever the points.
[[nodiscard]] CurvatureBlocks<3, false> hessian(const CornerShape& corner,
                                                const RowPoints<3>& points);

/// The clamped barrier of a share and its first two derivatives. [SHP-3]
///
///   B(s) = −(s − ŝ)² ln(s / ŝ) for 0 < s < ŝ, else 0,
///
/// twice continuously differentiable: a corner that keeps the share ŝ exerts no force at all.
struct Barrier {
  double value = 0.0;  ///< infinite for s ≤ 0
  double slope = 0.0;
  double curvature = 0.0;
};
[[nodiscard]] Barrier clamped_barrier(double share);

/// The corners of `face`, a triangle's three are one; then its inner triangles. Appends nothing for
/// corners with an edge of no length and for faces without area.
/// @param positions 3 × n of the base mesh
void append_corner_shapes(const Positions& positions, std::span<const int> face,
                          std::vector<CornerShape>& out);

}  // namespace planish
