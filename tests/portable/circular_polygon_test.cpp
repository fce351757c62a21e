// SPDX-License-Identifier: MIT
#include "planish/constraints/circular_polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "planish/mesh/adjacency.hpp"
#include "planish/problem/edit_freedom.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

const std::vector<int> kQuad{0, 1, 2, 3};

/// Points of a circle with radius 2 in a slanted plane, at `angles` in degrees.
Positions on_circle(const std::vector<double>& angles) {
  const Eigen::Vector3d x(0.6, 0.0, 0.8);
  const Eigen::Vector3d y(0.0, 1.0, 0.0);
  Positions points(3, static_cast<Eigen::Index>(angles.size()));
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double t = angles[k] * std::numbers::pi / 180.0;
    points.col(static_cast<Eigen::Index>(k)) =
        Eigen::Vector3d(7.0, -3.0, 1.0) + 2.0 * std::cos(t) * x + 2.0 * std::sin(t) * y;
  }
  return points;
}

RowPoints<4> corners(const CircleEquation& row, const Positions& points) {
  RowPoints<4> result;
  for (int k = 0; k < 4; ++k) result.col(k) = points.col(row.vertices[static_cast<std::size_t>(k)]);
  return result;
}

/// [CIR-1]
TEST(CircleEquation, ResidualIsTheDistanceFromTheCircle) {
  const std::vector<int> face{0, 1, 2, 3, 4};
  Positions points = on_circle({0, 70, 130, 200, 290});
  std::vector<CircleEquation> rows;
  append_circle_equations(points, face, rows);
  ASSERT_EQ(rows.size(), 2u);
  const Eigen::Vector3d centre(7.0, -3.0, 1.0);
  for (const CircleEquation& row : rows) {
    EXPECT_NEAR(residual(row, corners(row, points)), 0.0, 1e-14);
    Positions out = points;
    out.col(row.vertices[3]) += 1e-6 * (points.col(row.vertices[3]) - centre).normalized();
    EXPECT_NEAR(std::abs(residual(row, corners(row, out))), 1e-6, 1e-11);
  }
}

TEST(CircleEquation, TrianglesAndFacesWithoutAreaHaveNone) {
  std::vector<CircleEquation> rows;
  append_circle_equations(on_circle({0, 90, 180}), std::vector<int>{0, 1, 2}, rows);
  Positions line(3, 4);
  line << 0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0;
  append_circle_equations(line, kQuad, rows);
  EXPECT_TRUE(rows.empty());
}

/// [CIR-3] A kite with angles of 100°, 90°, 80°, 90° is circular, one of 120°, 90°, 60°, 90° too;
/// a rhombus of 100° and 80° misses by 20°.
TEST(CircleDefect, IsWhatOppositeAnglesMiss) {
  EXPECT_LT(circle_defect(on_circle({0, 10, 200, 340}), kQuad), 1e-12);
  EXPECT_LT(
      circle_defect(on_circle({0, 60, 120, 180, 240, 300}), std::vector<int>{0, 1, 2, 3, 4, 5}),
      1e-12);
  const double half = 50.0 * std::numbers::pi / 180.0;
  Positions rhombus(3, 4);
  rhombus << std::cos(half), 0, -std::cos(half), 0, 0, std::sin(half), 0, -std::sin(half), 0, 0, 0,
      0;
  EXPECT_NEAR(circle_defect(rhombus, kQuad), 20.0, 1e-12);
  EXPECT_EQ(circle_defect(rhombus, std::vector<int>{0, 1, 2}), 0.0);
}

TEST(CircleDefect, OfADartIsNotHiddenByItsReflexCorner) {
  Positions dart(3, 4);  // unsigned angles: one pair of opposite ones adds up to 180°
  dart << 0, 1, 0, -1, 1, 0, 1, 0, 0, 0, 0, 0;
  dart.col(2).y() = 1e-3;
  EXPECT_GT(circle_defect(dart, kQuad), 1.0);
}

TEST(CircleDefect, RoundingFarFromTheOriginIsNoExcess) {
  Positions points = on_circle({0, 70, 130, 250});
  points.colwise() += Eigen::Vector3d(4e6, 5e6, 0.0);
  EXPECT_GT(CircularPolygon::measure(points, kQuad), CircularPolygon::kTolerance);
  EXPECT_EQ(CircularPolygon::excess(points, kQuad), 0.0);
  points.col(0).x() += 1e-4;
  EXPECT_GT(CircularPolygon::excess(points, kQuad), 1e-3);
}

/// On a surface of revolution, which has a few directions more than other meshes.
TEST(CircleFreedom, IsFarSmallerThanThatOfFlatPanels) {
  const Mesh mesh = testing::sample("dome", 16);
  KeptKinds circular;
  circular.keep("circular", 1e-9);
  const auto freedom = [&](int rings, const KeptKinds& kept) {
    const std::vector<int> free = testing::ring_neighbourhood(mesh, 8 * 16 + 8, rings);
    const auto found = measure_freedom(mesh, build_adjacency(mesh), mesh.positions, free, {}, kept);
    return found ? found->freedom() : -1;
  };
  EXPECT_EQ(freedom(1, KeptKinds()), 12);
  EXPECT_EQ(freedom(1, circular), 2);
  EXPECT_EQ(freedom(2, KeptKinds()), 40);
  EXPECT_EQ(freedom(2, circular), 12);
}

}  // namespace
}  // namespace planish
