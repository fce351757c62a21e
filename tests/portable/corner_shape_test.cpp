// SPDX-License-Identifier: MIT
#include "planish/constraints/corner_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kStep = 1e-6;  ///< of a central difference

CornerShape corner_with(unsigned seed) {
  return {{0, 1, 2}, testing::random_points(seed + 100, 1).col(0), -0.3};
}

class CornerShapeAt : public ::testing::TestWithParam<unsigned> {};

TEST_P(CornerShapeAt, GradientIsTheDerivativeOfTheShare) {
  const CornerShape corner = corner_with(GetParam());
  const RowPoints<3> points = testing::random_points(GetParam(), 3);
  const RowPoints<3> derivative = gradient(corner, points);
  for (int k = 0; k < 9; ++k) {
    RowPoints<3> ahead = points, behind = points;
    ahead(k % 3, k / 3) += kStep;
    behind(k % 3, k / 3) -= kStep;
    const double difference = (residual(corner, ahead) - residual(corner, behind)) / (2 * kStep);
    EXPECT_NEAR(derivative(k % 3, k / 3), difference, 1e-8);
  }
}

TEST_P(CornerShapeAt, HessianIsTheDerivativeOfTheGradient) {
  const CornerShape corner = corner_with(GetParam());
  const RowPoints<3> points = testing::random_points(GetParam(), 3);
  const auto blocks = hessian(corner, points);
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 3; ++c) {
      RowPoints<3> ahead = points, behind = points;
      ahead(c, k) += kStep;
      behind(c, k) -= kStep;
      const RowPoints<3> column =
          (gradient(corner, ahead) - gradient(corner, behind)) / (2 * kStep);
      for (int l = 0; l < 3; ++l) {
        if (l == k) continue;
        const Eigen::Matrix3d& block =
            blocks[block_index<CornerShape>(std::max(k, l), std::min(k, l))];
        const Eigen::Matrix3d turned = l > k ? block : Eigen::Matrix3d(block.transpose());
        EXPECT_LT((column.col(l) - turned.col(c)).norm(), 1e-8);
      }
      EXPECT_LT(column.col(k).norm(), 1e-8);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CornerShapeAt, ::testing::ValuesIn(testing::seeds()));

TEST(ClampedBarrier, HasTheSlopeAndCurvatureOfItsValue) {
  for (const double share : {0.01, 0.1, 0.3, 0.49}) {
    const Barrier here = clamped_barrier(share);
    const Barrier ahead = clamped_barrier(share + kStep);
    const Barrier behind = clamped_barrier(share - kStep);
    EXPECT_NEAR(here.slope, (ahead.value - behind.value) / (2 * kStep), 1e-5);
    EXPECT_NEAR(here.curvature, (ahead.slope - behind.slope) / (2 * kStep), 1e-4);
  }
}

TEST(ClampedBarrier, IsNothingForASoundCornerAndInfiniteForALostOne) {
  for (const double share : {0.5, 0.75, 1.0, 3.0}) {
    EXPECT_EQ(clamped_barrier(share).value, 0.0);
    EXPECT_EQ(clamped_barrier(share).slope, 0.0);
    EXPECT_EQ(clamped_barrier(share).curvature, 0.0);
  }
  for (const double share : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(clamped_barrier(share).value, std::numeric_limits<double>::infinity());
  }
  EXPECT_GT(clamped_barrier(1e-12).value, clamped_barrier(1e-6).value);
}

TEST(CornerShapes, AreOneInTheBase) {
  const Mesh mesh = testing::sample("trihex", 8);
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<CornerShape> corners;
    append_corner_shapes(mesh.positions, mesh.face(f), corners);
    EXPECT_EQ(corners.size(), mesh.face(f).size() == 3 ? 1u : mesh.face(f).size());
    for (const CornerShape& corner : corners) {
      RowPoints<3> points;
      for (int k = 0; k < 3; ++k) {
        points.col(k) = mesh.positions.col(corner.vertices[static_cast<std::size_t>(k)]);
      }
      EXPECT_NEAR(residual(corner, points), 1.0, 1e-12);
    }
  }
}

/// A quad with its last corner pulled through the diagonal, a straight one, and one without area.
/// Corner (1, 0) of the quad (0, 0), (1, 0), (2, 0), (2, 2) may rise by what one degree is.
TEST(CornerShapes, LetAStraightCornerTurnByOneDegree) {
  Positions positions(3, 4);
  positions << 0, 1, 2, 2,  //
      0, 0, 0, 2,           //
      0, 0, 0, 0;
  std::vector<CornerShape> corners;
  append_corner_shapes(positions, std::vector<int>{0, 1, 2, 3}, corners);
  const CornerShape& straight = corners[1];
  const auto share = [&](double rise) {
    RowPoints<3> points = positions.leftCols<3>();
    points(1, 1) = rise;
    return residual(straight, points);
  };
  EXPECT_DOUBLE_EQ(share(0.0), 1.0);
  EXPECT_GT(share(-0.1), 1.0);  // outwards: nothing holds it
  EXPECT_NEAR(share(0.5 * kStraightTurn), 0.0, 1e-3);
  EXPECT_LT(share(kStraightTurn), 0.0);
}

TEST(CornerShapes, KeepAReflexCornerAndLeaveOutWhatHasNoArea) {
  Positions positions(3, 8);
  positions << 0, 2, 2, 1.5, 1, 3, 4, 5,  //
      0, 0, 2, 0.5, 0, 0, 0, 0,           //
      0, 0, 0, 0, 0, 0, 0, 0;
  std::vector<CornerShape> reflex, straight, line;
  append_corner_shapes(positions, std::vector<int>{0, 1, 2, 3}, reflex);
  append_corner_shapes(positions, std::vector<int>{0, 4, 1, 2}, straight);
  append_corner_shapes(positions, std::vector<int>{4, 5, 6, 7}, line);
  EXPECT_EQ(reflex.size(), 4u);
  EXPECT_EQ(straight.size(), 4u);
  EXPECT_TRUE(line.empty());
}

}  // namespace
}  // namespace planish
