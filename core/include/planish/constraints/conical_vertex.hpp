// SPDX-License-Identifier: MIT
/// The conical vertex: the faces at an inner vertex of valence 4 touch one cone of revolution.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "planish/constraints/kind.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// With ω_k the angle between the edges from the vertex to its neighbours k and k + 1, in order
/// around it,
///
///   c(p) = scale · (ω₁ − ω₂ + ω₃ − ω₄) = 0                                              [CV-1]
///
/// which flat faces at a vertex of valence 4 keep exactly where they touch one cone. The scale is
/// the mean length of the edges where the rows were made: the residual is a length.
struct ConeEquation {
  static constexpr int kArity = 5;
  static constexpr bool kCurvedDiagonal = true;
  std::array<int, 5> vertices{};  ///< the vertex, then its neighbours in order around it
  double scale = 1.0;
};

/// c with the vertices at `points`.
[[nodiscard]] double residual(const ConeEquation& equation, const RowPoints<5>& points);

/// ∂c/∂(vertex k) in column k. [CV-2]
[[nodiscard]] RowPoints<5> gradient(const ConeEquation& equation, const RowPoints<5>& points);

/// ∂²c, diagonal blocks too. [CV-2]
[[nodiscard]] CurvatureBlocks<5, true> hessian(const ConeEquation& equation,
                                               const RowPoints<5>& points);

/// |ω₁ − ω₂ + ω₃ − ω₄| in degrees; 0 where `star` has no four neighbours. [CV-1]
/// @param star a vertex, then its neighbours in order around it
[[nodiscard]] double cone_defect(const Positions& positions, std::span<const int> star);

/// The kind: every inner vertex of valence 4 is conical. Other vertices are left as they are.
struct ConicalVertex {
  static constexpr std::string_view kName = "conical";
  static constexpr std::string_view kUnit = "deg";
  static constexpr double kTolerance = 1e-9;
  static constexpr Element kElement = Element::kVertex;
  static constexpr Sense kSense = Sense::kZero;
  static constexpr int kStartRings = 3;  ///< fewer free points have no freedom [WSN-5]
  using Row = ConeEquation;

  static void append_rows(const Positions& positions, std::span<const int> star,
                          std::vector<Row>& out);
  [[nodiscard]] static double measure(const Positions& positions, std::span<const int> star) {
    return cone_defect(positions, star);
  }
  /// The defect, or 0 where the rounding of the star's own coordinates accounts for it. Rounding
  /// never accounts for more than 1e-3 deg.
  [[nodiscard]] static double excess(const Positions& positions, std::span<const int> star);
};

}  // namespace planish
