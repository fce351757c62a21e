// SPDX-License-Identifier: MIT
#include "planish/measures/metrics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

Positions quad_with_gap(double size, double gap) {
  Positions points(3, 4);
  points << 0, size, size, 0,  //
      0, 0, size, size,        //
      0, 0, 0, gap;
  return points;
}

/// Distance between the diagonals, and the unit normal that both are perpendicular to.
std::pair<double, Eigen::Vector3d> diagonals(const Positions& quad) {
  const Eigen::Vector3d normal =
      (quad.col(2) - quad.col(0)).cross(quad.col(3) - quad.col(1)).normalized();
  return {std::abs(normal.dot(quad.col(1) - quad.col(0))), normal};
}

/// Fig. 6: distance between the diagonals over the longest edge. The best-fit plane of a nearly
/// flat parallelogram lies half-way between them.
TEST(FacePlanarity, OfAParallelogramIsTheDistanceOfItsDiagonals) {
  const std::vector<int> face{0, 1, 2, 3};
  for (const unsigned seed : testing::seeds()) {
    Positions points = testing::random_points(seed, 4);
    points.col(2) = points.col(1) + points.col(3) - points.col(0);
    const Eigen::Vector3d normal = diagonals(points).second;
    points.col(1) += 5e-4 * normal;
    points.col(3) += 5e-4 * normal;
    const double distance = diagonals(points).first;
    const double longest =
        std::max((points.col(1) - points.col(0)).norm(), (points.col(3) - points.col(0)).norm());
    EXPECT_NEAR(face_planarity(points, face).gap, distance, 1e-5 * distance);
    EXPECT_NEAR(face_planarity(points, face).mm_per_m, 1e3 * distance / longest,
                1e-5 * 1e3 * distance / longest);
  }
  EXPECT_NEAR(face_planarity(quad_with_gap(1.0, 0.01), face).mm_per_m, 5.0, 0.01);
}

/// On a convex quad of any other shape the two measures differ by less than a factor of two.
TEST(FacePlanarity, OfAConvexQuadIsNearTheDistanceOfItsDiagonals) {
  const std::vector<int> face{0, 1, 2, 3};
  for (const unsigned seed : testing::seeds()) {
    Positions points = quad_with_gap(1.0, 0.001);
    points.topRows<2>() += 0.08 * testing::random_points(seed, 4).topRows<2>();
    const double ratio = face_planarity(points, face).gap / diagonals(points).first;
    EXPECT_GT(ratio, 0.5);
    EXPECT_LT(ratio, 2.0);
  }
}

TEST(FacePlanarity, DoesNotDependOnTheUnit) {
  const std::vector<int> face{0, 1, 2, 3};
  const double here = face_planarity(quad_with_gap(1.0, 0.02), face).mm_per_m;
  for (const double scale : {1e-9, 1e-3, 1e3, 1e12}) {
    const FacePlanarity there = face_planarity(quad_with_gap(scale, 0.02 * scale), face);
    EXPECT_NEAR(there.mm_per_m, here, 1e-9 * here);
    EXPECT_NEAR(there.gap, scale * here * 1e-3, 0.02 * scale * here * 1e-3);
  }
}

/// UTM coordinates: what remains is the rounding of the coordinates themselves.
TEST(FacePlanarity, SurvivesAnOffsetFarFromTheOrigin) {
  const std::vector<int> face{0, 1, 2, 3};
  Positions points = quad_with_gap(1.0, 0.02);
  const double here = face_planarity(points, face).mm_per_m;
  points.colwise() += Eigen::Vector3d(5e5, 5e6, 100);
  EXPECT_NEAR(face_planarity(points, face).mm_per_m, here, 1e-5);
}

TEST(FacePlanarity, IsZeroForTrianglesAndDegenerateFaces) {
  const std::vector<int> triangle{0, 1, 2}, quad{0, 1, 2, 3};
  EXPECT_EQ(face_planarity(testing::random_points(1, 4), triangle).mm_per_m, 0.0);
  EXPECT_EQ(face_planarity(Positions::Zero(3, 4), quad).mm_per_m, 0.0);
  Positions line = Positions::Zero(3, 4);
  line.row(0) << 0, 1, 2, 3;
  EXPECT_NEAR(face_planarity(line, quad).mm_per_m, 0.0, 1e-9);
}

TEST(PlanaritySummary, NamesTheWorstFaceAndAveragesOverPanels) {
  Mesh mesh = testing::quad_grid(4, 4);
  mesh.positions(2, 15) = 0.1;  // a corner: one face only
  const PlanaritySummary summary = planarity_summary(mesh);
  EXPECT_EQ(summary.worst_face, 8);
  EXPECT_GT(summary.max, 40.0);
  EXPECT_NEAR(summary.mean, summary.max / 9, 1e-9);
  EXPECT_EQ(planarity_summary(testing::triangle_grid(3, 3)).worst_face, -1);
}

TEST(PlanaritySummary, GivesTheGapOfTheFaceThatItNames) {
  const Mesh mesh = testing::make_mesh({{0, 0, 0},
                                        {20, 0, 0},
                                        {20, 20, 0},
                                        {0, 20, 1},  // wide: the larger gap
                                        {30, 0, 0},
                                        {31, 0, 0},
                                        {31, 1, 0},
                                        {30, 1, 0.2}},  // small: more mm/m
                                       {{0, 1, 2, 3}, {4, 5, 6, 7}});
  const PlanaritySummary summary = planarity_summary(mesh);
  const FacePlanarity wide = face_planarity(mesh.positions, mesh.face(0));
  const FacePlanarity small = face_planarity(mesh.positions, mesh.face(1));
  EXPECT_EQ(summary.worst_face, 1);
  EXPECT_EQ(summary.max, small.mm_per_m);
  EXPECT_EQ(summary.worst_gap, small.gap);
  EXPECT_EQ(summary.max_gap, wide.gap);
  EXPECT_GT(wide.gap, small.gap);
}

/// Sec. 2.1: about 2 N_V for planar quads and for tri-hex meshes, 1.5 N_V for hexagons. The
/// boundary adds a term of the order of its length.
TEST(DegreesOfFreedom, ArePerVertexAsThePaperCounts) {
  const auto per_vertex = [](const char* name) {
    const Mesh mesh = testing::sample(name, 100);
    return static_cast<double>(degrees_of_freedom(mesh)) / mesh.vertex_count();
  };
  EXPECT_NEAR(per_vertex("vault"), 2.0, 0.05);
  EXPECT_NEAR(per_vertex("trihex"), 2.0, 0.05);
  EXPECT_NEAR(per_vertex("hex"), 1.5, 0.05);
}

TEST(DegreesOfFreedom, LeaveIsolatedVerticesOut) {
  const Mesh mesh =
      testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}}, {{0, 1, 2, 3}});
  EXPECT_EQ(degrees_of_freedom(mesh), 3 * 4 - 1);
  EXPECT_EQ(degrees_of_freedom(testing::sample("vault", 32)), 3 * 1024 - 961);
}

TEST(MovedVertexCount, SeesEveryBit) {
  const Positions before = testing::random_points(1, 5);
  Positions after = before;
  EXPECT_EQ(moved_vertex_count(before, after), 0);
  after(1, 3) = std::nextafter(after(1, 3), 10.0);
  EXPECT_EQ(moved_vertex_count(before, after), 1);
  Positions zero = Positions::Zero(3, 1);
  EXPECT_EQ(moved_vertex_count(zero, -zero), 1) << "-0 has other bits than 0";
}

TEST(MeanEdgeLength, CountsEachEdgeOnce) {
  Mesh mesh = testing::quad_grid(3, 2);
  EXPECT_DOUBLE_EQ(mean_edge_length(mesh), 1.0);
  mesh.positions.row(0) *= 2.0;  // 4 edges of length 2, 3 of length 1
  EXPECT_DOUBLE_EQ(mean_edge_length(mesh), 11.0 / 7.0);
  EXPECT_EQ(mean_edge_length(Mesh{}), 0.0);
}

}  // namespace
}  // namespace planish
