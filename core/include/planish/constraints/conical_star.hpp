// SPDX-License-Identifier: MIT
/// The conical star: the faces at an inner vertex of valence 5 or more touch one cone of
/// revolution. Part of the kind "conical", beside ConicalVertex.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "planish/constraints/conical_vertex.hpp"
#include "planish/constraints/kind.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Planes touch one cone where their unit normals are at one angle to its axis: on a circle. With
/// n₀, n₁, n₂ the normals of three faces about a third of the star apart and n₃ that of a fourth,
///
///   c(p) = scale · det(n₁ − n₀, n₂ − n₀, n₃ − n₀) / ‖(n₁ − n₀) × (n₂ − n₀)‖ = 0            [CV-3]
///
/// Without the divisor the row would hold where the three fall together, and be drawn there. The
/// scale makes it the angle by which the fourth is off the cone of the three, times the mean
/// length of the edges where the rows were made: a length, as in [CV-1].
struct NormalsOnCircle {
  static constexpr int kArity = 9;
  static constexpr bool kCurvedDiagonal = true;
  /// The vertex, then the neighbours that bound the four faces; the vertex again where they are
  /// less than eight.
  std::array<int, kArity> vertices{};
  /// Of each face the two neighbours that bound it, by their places in `vertices`.
  std::array<std::array<int, 2>, 4> arms{};
  double scale = 1.0;
};

/// c with the vertices at `points`.
[[nodiscard]] double residual(const NormalsOnCircle& row, const RowPoints<9>& points);

/// ∂c/∂(vertex k) in column k, up to multiples of the residual. [CV-4]
[[nodiscard]] RowPoints<9> gradient(const NormalsOnCircle& row, const RowPoints<9>& points);

/// ∂²c, diagonal blocks too, along directions that keep it. [CV-4]
[[nodiscard]] CurvatureBlocks<9, true> hessian(const NormalsOnCircle& row,
                                               const RowPoints<9>& points);

/// The largest angle in degrees by which a face is off the cone of the three; 0 where `star` has
/// fewer than five neighbours, or is flat. [CV-3]
/// @param star a vertex, then its neighbours in order around it
[[nodiscard]] double star_defect(const Positions& positions, std::span<const int> star);

/// The kind: every inner vertex of valence 5 or more that is not flat. (With valence 3 it is always
/// conical.)
struct ConicalStar {
  static constexpr std::string_view kName = ConicalVertex::kName;
  static constexpr std::string_view kUnit = ConicalVertex::kUnit;
  static constexpr double kTolerance = ConicalVertex::kTolerance;
  static constexpr Element kElement = ConicalVertex::kElement;
  static constexpr Sense kSense = ConicalVertex::kSense;
  static constexpr int kStartRings = ConicalVertex::kStartRings;
  using Row = NormalsOnCircle;

  static void append_rows(const Positions& positions, std::span<const int> star,
                          std::vector<Row>& out);
  [[nodiscard]] static double measure(const Positions& positions, std::span<const int> star) {
    return star_defect(positions, star);
  }
  /// The defect, or 0 where the rounding of the star's own coordinates accounts for it. Rounding
  /// never accounts for more than 1e-3 deg.
  [[nodiscard]] static double excess(const Positions& positions, std::span<const int> star);
};

}  // namespace planish
