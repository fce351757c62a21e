// SPDX-License-Identifier: MIT
#include "planish/constraints/corner_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "support/central_difference.hpp"
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
  const auto share = [&](const RowPoints<3>& at) { return residual(corner, at); };
  for (int k = 0; k < 9; ++k) {
    EXPECT_NEAR(derivative.data()[k], testing::central_difference(points, k, kStep, share), 1e-8);
  }
}

TEST_P(CornerShapeAt, HessianIsTheDerivativeOfTheGradient) {
  const CornerShape corner = corner_with(GetParam());
  const RowPoints<3> points = testing::random_points(GetParam(), 3);
  const auto blocks = hessian(corner, points);
  const auto rise = [&](const RowPoints<3>& at) { return gradient(corner, at); };
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 3; ++c) {
      const RowPoints<3> column = testing::central_difference(points, 3 * k + c, kStep, rise);
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

/// A simple outline: its corners one after the other around a point, near and far.
Positions random_outline(unsigned seed, int corners) {
  constexpr double kTurn = 6.283185307179586;
  const Eigen::VectorXd random = testing::random_vector(seed, 2 * corners);
  Positions outline(3, corners);
  for (int k = 0; k < corners; ++k) {
    const double angle = kTurn * (k + 0.3 * std::tanh(random[2 * k])) / corners;
    const double radius = std::exp(0.6 * std::tanh(random[2 * k + 1]));
    outline.col(k) << radius * std::cos(angle), radius * std::sin(angle), 0.0;
  }
  return outline;
}

/// Whether two sides without a common corner have a common point.
bool sides_meet(const Positions& p) {
  const auto side = [&](Eigen::Index a, Eigen::Index b, Eigen::Index c) {
    const Eigen::Vector3d u = p.col(b) - p.col(a), v = p.col(c) - p.col(a);
    return u.x() * v.y() - u.y() * v.x();
  };
  const Eigen::Index n = p.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = i + 2; j < n; ++j) {
      const Eigen::Index a = i, b = i + 1, c = j, d = (j + 1) % n;
      if (d == a) continue;
      if (side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0) return true;
    }
  }
  return false;
}

/// Reflex corners go to the other side, the other ones their own ways: in the plane, a share each.
Positions random_way(unsigned seed, const Positions& outline) {
  Positions way = 0.1 * testing::random_points(seed + 7919, outline.cols());
  for (Eigen::Index k = 0; k < way.cols(); ++k) {
    const Eigen::Index n = way.cols();
    const Eigen::Vector3d in = outline.col(k) - outline.col((k + n - 1) % n);
    const Eigen::Vector3d out = outline.col((k + 1) % n) - outline.col(k);
    if (in.cross(out).z() < 0.0) way.col(k) -= outline.col(k);
  }
  way.row(2).setZero();
  return way;
}

/// No outline with reflex corners crosses itself before a row says so. By corners alone many would.
TEST(CornerShapes, KeepAnOutlineFromCrossingItself) {
  constexpr int kOutlines = 400;
  constexpr int kSteps = 200;
  int reflex = 0, held_by_triangles = 0;
  for (int outline = 0; outline < kOutlines; ++outline) {
    SCOPED_TRACE(outline);
    const int n = 5 + outline % 5;
    const auto seed = static_cast<unsigned>(outline);
    const Positions base = random_outline(seed, n);
    const Positions way = random_way(seed, base);
    std::vector<int> face(static_cast<std::size_t>(n));
    std::iota(face.begin(), face.end(), 0);
    std::vector<CornerShape> rows;
    append_corner_shapes(base, face, rows);
    reflex += rows.size() > face.size() ? 1 : 0;
    bool stopped = false;
    for (int step = 1; step <= kSteps; ++step) {
      const Positions now = base + 3.0 * step / kSteps * way;
      const auto breaks = [&](const CornerShape& row) {
        const std::vector<int> vertices(row.vertices.begin(), row.vertices.end());
        return residual(row, now(Eigen::all, vertices)) <= 0.0;
      };
      const auto first_triangle = rows.begin() + n;
      if (std::any_of(rows.begin(), first_triangle, breaks)) break;
      stopped = stopped || std::any_of(first_triangle, rows.end(), breaks);
      if (!sides_meet(now)) continue;
      ASSERT_TRUE(stopped) << "step " << step;
      ++held_by_triangles;
      break;
    }
  }
  EXPECT_GT(reflex, kOutlines / 2);
  EXPECT_GT(held_by_triangles, kOutlines / 20);
}

TEST(CornerShapes, OfConvexPanelsAreTheirCornersAlone) {
  const Mesh mesh = testing::sample("hex", 8);
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<CornerShape> corners;
    append_corner_shapes(mesh.positions, mesh.face(f), corners);
    EXPECT_EQ(corners.size(), mesh.face(f).size());
  }
}

}  // namespace
}  // namespace planish
