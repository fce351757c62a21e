// SPDX-License-Identifier: MIT
#include "planish/constraints/straight_corner.hpp"

#include "planish/constraints/vector_pair.hpp"

namespace planish {
namespace {

/// Of kStraightTurn, which the verdict holds against the angle itself: where a panel turns away
/// from its base and its sides get shorter the row's sine falls short of that.
constexpr double kShareOfTurn = 0.1;
constexpr double kTurnWidth = 0.1;  ///< of the sine, between the bound and s = 1

CornerShape without_offset(const StraightCorner& corner) {
  return {corner.vertices, corner.normal, 0.0};
}

}  // namespace

double value(const StraightCorner& corner, const RowPoints<3>& points) {
  return residual(without_offset(corner), points);
}

RowPoints<3> gradient(const StraightCorner& corner, const RowPoints<3>& points) {
  return gradient(without_offset(corner), points);
}

LimitHessian<3> hessian(const StraightCorner& corner, const RowPoints<3>& /*points*/) {
  const Eigen::Matrix3d twist = cross_matrix(corner.normal);
  LimitHessian<3> result;
  result << Eigen::Matrix3d::Zero(), -twist, twist,  //
      twist, Eigen::Matrix3d::Zero(), -twist,        //
      -twist, twist, Eigen::Matrix3d::Zero();
  return result;
}

StraightCorner straight_corner(const CornerShape& corner) {
  return {corner.vertices, corner.normal * kStraightTurn,
          LimitScale::at_least(-kShareOfTurn * kStraightTurn, 0.0, kTurnWidth, 0.0)};
}

}  // namespace planish
