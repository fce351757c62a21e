// SPDX-License-Identifier: MIT
#include "planish/constraints/straight_corner.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/central_difference.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kApart = 1e-6;  ///< of a central difference

class StraightCornerAt : public ::testing::TestWithParam<unsigned> {
 protected:
  StraightCorner corner_ = straight_corner(
      {{0, 1, 2}, testing::random_points(GetParam() + 100, 1).col(0) / kStraightTurn, 1.0});
  RowPoints<3> points_ = testing::random_points(GetParam(), 3);
};

TEST_P(StraightCornerAt, HasTheDerivativesOfItsValue) {
  const RowPoints<3> slope = gradient(corner_, points_);
  const LimitHessian<3> curvature = hessian(corner_, points_);
  const auto height = [&](const RowPoints<3>& points) { return value(corner_, points); };
  const auto rise = [&](const RowPoints<3>& points) { return gradient(corner_, points); };
  for (int k = 0; k < 9; ++k) {
    EXPECT_NEAR(slope.data()[k], testing::central_difference(points_, k, kApart, height), 1e-8);
    const RowPoints<3> column = testing::central_difference(points_, k, kApart, rise);
    EXPECT_LT((column.reshaped() - curvature.col(k)).norm(), 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, StraightCornerAt, ::testing::ValuesIn(testing::seeds()));

/// Corner (1, 0) of the quad (0, 0), (1, 0), (2, 0), (2, 2) may rise by what a tenth of a degree
/// is.
TEST(StraightCorner, TurnsInwardsByATenthOfADegreeAndOutwardsFreely) {
  Positions positions(3, 4);
  positions << 0, 1, 2, 2,  //
      0, 0, 0, 2,           //
      0, 0, 0, 0;
  std::vector<CornerShape> corners;
  append_corner_shapes(positions, std::vector<int>{0, 1, 2, 3}, corners);
  EXPECT_FALSE(is_straight(corners[0]));
  ASSERT_TRUE(is_straight(corners[1]));
  const StraightCorner straight = straight_corner(corners[1]);
  const auto share = [&](double rise) {
    RowPoints<3> points = positions.leftCols<3>();
    points(1, 1) = rise;
    return straight.scale.share(value(straight, points));
  };
  EXPECT_GT(share(0.0), 0.0);
  EXPECT_GT(share(-0.1), share(0.0));
  EXPECT_NEAR(share(0.05 * kStraightTurn), 0.0, 1e-12);
  EXPECT_LT(share(0.1 * kStraightTurn), 0.0);
  EXPECT_FALSE(straight.scale.exceeded);
}

}  // namespace
}  // namespace planish
