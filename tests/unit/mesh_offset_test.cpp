// SPDX-License-Identifier: MIT
#include "planish/offset/mesh_offset.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "planish/measures/metrics.hpp"
#include "support/circles.hpp"
#include "support/mesh_builders.hpp"
#include "support/offset_checks.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::offset_of;
using testing::refusal;

/// A band of quads with half a twist: one side only.
Mesh moebius(int count) {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < count; ++i) {
    const double t = 2.0 * std::numbers::pi * i / count;
    const Eigen::Vector3d out(std::cos(t), std::sin(t), 0.0);
    const Eigen::Vector3d across =
        std::cos(t / 2.0) * out + std::sin(t / 2.0) * Eigen::Vector3d::UnitZ();
    points.push_back(3.0 * out - 0.5 * across);
    points.push_back(3.0 * out + 0.5 * across);
  }
  for (int i = 0; i < count; ++i) {  // triangles, so that every panel is flat
    const int a = 2 * i, b = 2 * i + 1;
    const int c = i + 1 < count ? a + 2 : 1, d = i + 1 < count ? a + 3 : 0;
    faces.push_back({a, b, d});
    faces.push_back({a, d, c});
  }
  return testing::make_mesh(points, faces);
}

TEST(OffsetMesh, OfACubeIsALargerCube) {
  const Mesh cube = testing::cube();
  const MeshOffset outside = offset_of(cube, 0.5);
  EXPECT_EQ(outside.report.kind, OffsetKind::kFace);
  EXPECT_LT((outside.positions - 1.5 * cube.positions).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT((outside.axes - cube.positions).cwiseAbs().maxCoeff(), 1e-15);
  const OffsetReport& report = outside.report;
  EXPECT_NEAR(report.panels.mean, 0.5, 1e-15);
  EXPECT_NEAR(report.heights.min, 0.5 * std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(report.nodes.max, 0.5 * std::sqrt(3.0), 1e-15);
  EXPECT_EQ(report.turned_edges, 0);
  const MeshOffset inside = offset_of(cube, -0.5);
  EXPECT_LT((inside.positions - 0.5 * cube.positions).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NEAR(inside.report.panels.min, -0.5, 1e-15);
  EXPECT_NEAR(inside.report.nodes.max, -0.5 * std::sqrt(3.0), 1e-15);
}

TEST(OffsetMesh, KeepsEveryBitAtDistanceZero) {
  Mesh grid = testing::quad_grid(4, 3);
  grid.positions.row(2).setConstant(-0.0);
  EXPECT_TRUE(testing::same_bits(offset_of(grid, 0.0).positions, grid.positions));
  const Mesh dome = testing::sample("dome", 9);
  EXPECT_TRUE(testing::same_bits(offset_of(dome, 0.0).positions, dome.positions));
}

TEST(OffsetMesh, TakesTheSideOfMostPanelsForOutside) {
  Mesh cube = testing::cube();
  for (const std::size_t f : {1u, 4u})
    std::swap(cube.face_vertices[4 * f], cube.face_vertices[4 * f + 2]);
  const MeshOffset offset = offset_of(cube, 0.5);
  EXPECT_LT((offset.positions - 1.5 * cube.positions).cwiseAbs().maxCoeff(), 1e-15);
  for (std::size_t f = 0; f < 6; ++f)
    std::swap(cube.face_vertices[4 * f], cube.face_vertices[4 * f + 2]);
  const MeshOffset inverted = offset_of(cube, 0.5);
  EXPECT_LT((inverted.positions - 0.5 * cube.positions).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(OffsetMesh, OfPointsOnASphereIsOneOfPointsOnASphere) {
  const Mesh cube = testing::cube();
  const MeshOffset offset = offset_of(cube, 0.5, OffsetKind::kVertex);
  const double scale = 1.0 + 0.5 / std::sqrt(3.0);
  EXPECT_LT((offset.positions - scale * cube.positions).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT(offset.report.deviation, 1e-15);
  EXPECT_NEAR(offset.report.panels.max, 0.5 / std::sqrt(3.0), 1e-15);
}

/// Two panels at 45 degrees.
Mesh gable() {
  return testing::make_mesh({{-1, 0, 0}, {-1, 3, 0}, {0, 0, 1}, {0, 3, 1}, {1, 0, 0}, {1, 3, 0}},
                            {{0, 2, 3, 1}, {2, 4, 5, 3}});
}

/// By hand: the ridge rises by √2 of the distance, the eaves along their panel's normal.
TEST(OffsetMesh, OfAGableHasItsRidgeOnTheBisector) {
  const MeshOffset offset = offset_of(gable(), 0.1);
  EXPECT_EQ(offset.report.kind, OffsetKind::kFace);
  const double half = std::sqrt(0.5);
  for (const int y : {0, 1}) {
    EXPECT_LT((offset.axes.col(y) - Eigen::Vector3d(-half, 0, half)).norm(), 1e-14);
    EXPECT_LT((offset.axes.col(2 + y) - Eigen::Vector3d(0, 0, 2.0 * half)).norm(), 1e-14);
    EXPECT_LT((offset.axes.col(4 + y) - Eigen::Vector3d(half, 0, half)).norm(), 1e-14);
  }
}

TEST(OffsetMesh, OfFlatPanelsGoesStraightUp) {
  const Mesh grid = testing::quad_grid(5, 4);
  for (const auto kind : {OffsetKind::kFace, OffsetKind::kVertex, OffsetKind::kParallel}) {
    const MeshOffset offset = offset_of(grid, -0.3, kind);
    const Positions moves = offset.positions - grid.positions;
    EXPECT_LT((moves.colwise() - Eigen::Vector3d(0, 0, -0.3)).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(OffsetMesh, OfTrianglesIsTheMeshScaled) {
  Mesh mesh = testing::triangle_grid(5, 5);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    mesh.positions(2, v) = std::sin(1.3 * v) + 0.3 * mesh.positions(0, v);
  }
  const MeshOffset offset = offset_of(mesh, 0.4);
  EXPECT_EQ(offset.report.kind, OffsetKind::kParallel);
  const Eigen::Vector3d edge = mesh.positions.col(1) - mesh.positions.col(0);
  const double scale =
      edge.dot(offset.positions.col(1) - offset.positions.col(0)) / edge.squaredNorm();
  const Positions rest = offset.positions - scale * mesh.positions;
  EXPECT_LT((rest.colwise() - rest.col(0)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(OffsetMesh, CountsTheEdgesThatTurnAround) {
  const Mesh cube = testing::cube();
  EXPECT_EQ(offset_of(cube, -0.9).report.turned_edges, 0);
  EXPECT_EQ(offset_of(cube, -3.0).report.turned_edges, 12);
}

TEST(OffsetMesh, ReportsWhatItMeasures) {
  const Mesh vault = testing::sample("vault", 12);
  const MeshOffset offset = offset_of(vault, 0.25);
  const OffsetReport& report = offset.report;
  EXPECT_EQ(report.kind, OffsetKind::kParallel);
  EXPECT_EQ(report.deviation, 0.0);
  EXPECT_LT(report.panels.min, report.panels.mean);
  EXPECT_LT(report.panels.mean, report.panels.max);
  const Eigen::RowVectorXd lengths = (offset.positions - vault.positions).colwise().norm();
  EXPECT_NEAR(report.nodes.min, lengths.minCoeff(), 1e-12);
  EXPECT_NEAR(report.nodes.mean, lengths.mean(), 1e-12);
  EXPECT_NEAR(report.nodes.max, lengths.maxCoeff(), 1e-12);
  EXPECT_LE(report.heights.max, report.nodes.max);
  EXPECT_GT(report.largest_lean, 0.1);
  EXPECT_LT(report.largest_lean, 10.0);
}

TEST(OffsetMesh, SaysWhyThereIsNone) {
  const Mesh vault = testing::sample("vault", 9);
  EXPECT_NE(refusal(vault, OffsetKind::kFace).find("misses being conical by"), std::string::npos);
  EXPECT_NE(refusal(vault, OffsetKind::kFace).find("project --constraint conical"),
            std::string::npos);
  EXPECT_NE(refusal(vault, OffsetKind::kVertex).find("misses a circle by"), std::string::npos);
  EXPECT_NE(refusal(vault, OffsetKind::kVertex).find("project --constraint circular"),
            std::string::npos);
  EXPECT_EQ(refusal(vault), "");
  Mesh bent = vault;
  bent.positions(2, 4 * 9 + 4) += 0.1;
  for (const auto kind : {OffsetKind::kFace, OffsetKind::kVertex, OffsetKind::kParallel}) {
    EXPECT_NE(refusal(bent, kind).find("out of its plane by"), std::string::npos);
  }
  EXPECT_NE(refusal(moebius(12)).find("one side only"), std::string::npos);
}

TEST(OffsetMesh, SaysWhatNoProjectionMends) {
  Mesh mesh = testing::triangle_grid(5, 5);
  for (int v = 0; v < mesh.vertex_count(); ++v) mesh.positions(2, v) = std::sin(1.3 * v);
  const std::string planes = refusal(mesh, OffsetKind::kFace);
  EXPECT_NE(planes.find("miss a common point by"), std::string::npos) << planes;
  EXPECT_EQ(planes.find("project"), std::string::npos) << planes;
  const std::string points = refusal(mesh, OffsetKind::kVertex);
  EXPECT_NE(points.find("odd number of corners"), std::string::npos) << points;
}

TEST(OffsetOptions, RefuseDistancesThatAreNone) {
  for (const double distance : {std::nan(""), std::numeric_limits<double>::infinity(), -1e101}) {
    EXPECT_NE(find_problem(OffsetOptions{distance, {}})->find("distance"), std::string::npos);
  }
  EXPECT_FALSE(find_problem(OffsetOptions{-1e100, {}}));
  EXPECT_NE(std::get<std::string>(offset_mesh(gable(), {1e100, {}})).find("1e100"),
            std::string::npos);
}

TEST(OffsetKinds, HaveNames) {
  for (const auto kind : {OffsetKind::kFace, OffsetKind::kVertex, OffsetKind::kParallel}) {
    EXPECT_EQ(offset_kind(kind_name(kind)), kind);
  }
  EXPECT_EQ(offset_kind("edge"), std::nullopt);
}

}  // namespace
}  // namespace planish
