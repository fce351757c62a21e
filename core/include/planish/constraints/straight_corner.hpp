// SPDX-License-Identifier: MIT
/// A corner that is straight in the base, in an edit. [SHP-4]
///
/// It has no side to keep, and next to no room to turn inwards: a barrier in there cuts every step.
/// So its row has a multiplier, as a stated limit's has. g is the sine of its turn, in lengths of
/// the base.
#pragma once

#include <Eigen/Core>
#include <array>

#include "planish/constraints/corner_shape.hpp"
#include "planish/constraints/limit_kind.hpp"

namespace planish {

struct StraightCorner {
  static constexpr int kArity = 3;
  std::array<int, 3> vertices{};                     ///< previous, this, next
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< n⁰ / (‖b − a‖ ‖c − b‖)
  LimitScale scale;
};

[[nodiscard]] double value(const StraightCorner& corner, const RowPoints<3>& points);
[[nodiscard]] RowPoints<3> gradient(const StraightCorner& corner, const RowPoints<3>& points);
[[nodiscard]] LimitHessian<3> hessian(const StraightCorner& corner, const RowPoints<3>& points);

static_assert(LimitRow<StraightCorner>);

/// @param corner that is_straight()
[[nodiscard]] StraightCorner straight_corner(const CornerShape& corner);

}  // namespace planish
