// SPDX-License-Identifier: MIT
/// The circular polygon: every vertex of a flat face on one circle.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "planish/constraints/kind.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// q lies on the circle through a, b, c of a flat panel: with u, v, w = b − a, c − a, q − a
///
///   c(p) = n · (‖u‖² v × w + ‖v‖² w × u + ‖w‖² u × v) = 0,                              [CIR-1]
///
/// the power of q times the area of the triangle. n is the unit area vector of the panel where the
/// rows were made, times a scale that turns the residual into the distance of q from the circle. In
/// a flat panel the bracket is parallel to the panel's own area vector, so c vanishes on a circle
/// alone, unless the panel turned by 90°; and as n is constant, c is a polynomial.
struct CircleEquation {
  static constexpr int kArity = 4;
  static constexpr bool kCurvedDiagonal = true;
  std::array<int, 4> vertices{};  ///< a, b, c, q
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// c with the corners at `points`.
[[nodiscard]] double residual(const CircleEquation& equation, const RowPoints<4>& points);

/// ∂c/∂(vertex k) in column k. [CIR-2]
[[nodiscard]] RowPoints<4> gradient(const CircleEquation& equation, const RowPoints<4>& points);

/// ∂²c, diagonal blocks too. [CIR-2]
[[nodiscard]] CurvatureBlocks<4, true> hessian(const CircleEquation& equation,
                                               const RowPoints<4>& points);

/// The n − 3 equations of `face`, carried by the three vertices that carry its plane. Appends
/// nothing for a triangle and for a face without area.
void append_circle_equations(const Positions& positions, std::span<const int> face,
                             std::vector<CircleEquation>& out);

/// Degrees by which two opposite angles of four consecutive vertices miss 180°, the largest over
/// the face; 0 for triangles. On a convex face it is zero exactly where all lie on a circle.
/// [CIR-3]
[[nodiscard]] double circle_defect(const Positions& positions, std::span<const int> face);

/// The kind: every vertex of a flat face on one circle.
struct CircularPolygon {
  static constexpr std::string_view kName = "circular";
  static constexpr std::string_view kUnit = "deg";
  static constexpr double kTolerance = 1e-9;
  static constexpr Element kElement = Element::kFace;
  static constexpr Sense kSense = Sense::kZero;
  static constexpr bool kPresumesFlat = true;
  using Row = CircleEquation;

  static void append_rows(const Positions& positions, std::span<const int> face,
                          std::vector<Row>& out) {
    append_circle_equations(positions, face, out);
  }
  [[nodiscard]] static double measure(const Positions& positions, std::span<const int> face) {
    return circle_defect(positions, face);
  }
  /// The defect, or 0 where the rounding of the face's own coordinates accounts for it. Rounding
  /// never accounts for more than 1e-3 deg.
  [[nodiscard]] static double excess(const Positions& positions, std::span<const int> face);
};

}  // namespace planish
