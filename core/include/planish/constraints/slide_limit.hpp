// SPDX-License-Identifier: MIT
/// The limit on slides: how far a point may go across the normal of the base there, which shifts
/// joints and leaves the shape. g = ‖d − (n·d) n‖², d the point's displacement, n the mean normal
/// of the panels around it in the base. [LIM-8]
///
/// Convex, so that a design at its limit is never held back from both sides. A point that no panel
/// has, or whose panels' normals cancel, slides with its whole displacement. Handles count as other
/// points do: one whose target is further across the normal stops at the limit.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "planish/constraints/limit_kind.hpp"

namespace planish {

struct SlideRow {
  static constexpr int kArity = 1;
  std::array<int, 1> vertices{};
  LimitScale scale;
  Eigen::Vector3d place;   ///< in the base
  Eigen::Vector3d normal;  ///< there; 0 where there is none
};

[[nodiscard]] double value(const SlideRow& row, const RowPoints<1>& points);
[[nodiscard]] RowPoints<1> gradient(const SlideRow& row, const RowPoints<1>& points);
[[nodiscard]] LimitHessian<1> hessian(const SlideRow& row, const RowPoints<1>& points);

/// slide=MAX, model units; the same measure as PointMotion::slide.
struct SlideLimit {
  static constexpr std::string_view kName = "slide";
  static constexpr std::string_view kForm = "MAX";
  using Row = SlideRow;
  /// Appends one row for each corner of `face` that no face of a lower number has.
  static void append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                          std::vector<Row>& out);
};

}  // namespace planish
