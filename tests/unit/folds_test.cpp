// SPDX-License-Identifier: MIT
#include "planish/measures/folds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

/// A strip of three squares in x, its last one turned up by `angle` degrees.
Mesh strip(double angle) {
  Mesh mesh = testing::quad_grid(4, 2);
  for (const int v : {3, 7}) {
    mesh.positions(0, v) = 2.0 + std::cos(angle / kDegrees);
    mesh.positions(2, v) = std::sin(angle / kDegrees);
  }
  return mesh;
}

Fold fold_of(const Mesh& mesh, const std::vector<int>& faces) {
  return sharpest_fold(mesh, build_adjacency(mesh), mesh.positions, faces);
}

TEST(SharpestFold, IsTheAngleBetweenTheNormals) {
  for (const double angle : {1e-6, 3.0, 45.0, 90.0, 135.0, 179.9}) {
    const Fold fold = fold_of(strip(angle), {1});
    EXPECT_NEAR(fold.degrees, angle, 1e-7) << angle;
    EXPECT_EQ(fold.face, 1);
    EXPECT_EQ(fold.neighbour, 2);
  }
}

TEST(SharpestFold, IsOfTheFacesAskedForAndTheirNeighbours) {
  const Mesh mesh = strip(30.0);
  EXPECT_EQ(fold_of(mesh, {0}).degrees, 0.0);
  EXPECT_NEAR(fold_of(mesh, {2}).degrees, 30.0, 1e-7);
  EXPECT_EQ(fold_of(mesh, {}).face, -1);
}

TEST(FoldGrowth, IsOfTheFoldThatSharpenedMost) {
  const Mesh mesh = strip(30.0);
  const auto growth = [&](double before, double after, const std::vector<int>& faces) {
    return largest_fold_growth(mesh, build_adjacency(mesh), strip(before).positions,
                               strip(after).positions, faces);
  };
  EXPECT_NEAR(growth(30.0, 42.0, {2}), 12.0, 1e-7);
  EXPECT_EQ(growth(30.0, 20.0, {2}), 0.0);
  EXPECT_EQ(growth(30.0, 42.0, {0}), 0.0) << "not a fold of this face";
}

TEST(FaceFolds, AreTheSharpestOfEachFaceWithItsNeighbours) {
  const std::vector<double> folds = face_folds(strip(30.0), strip(30.0).positions);
  ASSERT_EQ(folds.size(), 3u);
  EXPECT_EQ(folds[0], 0.0);
  EXPECT_NEAR(folds[1], 30.0, 1e-7);
  EXPECT_EQ(folds[2], folds[1]);
}

TEST(SharpestFold, DoesNotDependOnOrientationOrPlace) {
  Mesh mesh = strip(30.0);
  std::reverse(mesh.face_vertices.begin() + mesh.face_offsets[2],
               mesh.face_vertices.begin() + mesh.face_offsets[3]);
  EXPECT_NEAR(fold_of(mesh, {2}).degrees, 30.0, 1e-7);
  mesh.positions *= 1e-3;
  mesh.positions.colwise() += Eigen::Vector3d(1e3, -1e3, 1e3);
  EXPECT_NEAR(fold_of(mesh, {2}).degrees, 30.0, 1e-6);
}

/// A third panel on the same edge: which two would be neighbours is not defined.
TEST(SharpestFold, PassesOverAnEdgeOfThreePanels) {
  Mesh mesh = strip(30.0);
  mesh.positions.conservativeResize(3, 10);
  mesh.positions.col(8) = Eigen::Vector3d(2, 0, -1);
  mesh.positions.col(9) = Eigen::Vector3d(2, 1, -1);
  for (const int v : {2, 8, 9, 6}) mesh.face_vertices.push_back(v);
  mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
  EXPECT_EQ(fold_of(mesh, {0, 1, 2, 3}).degrees, 0.0);
}

TEST(FacesOf, AreThoseOfTheVerticesOnce) {
  const Adjacency adjacency = build_adjacency(strip(10.0));
  const std::vector<int> vertices{1, 5, 2};
  EXPECT_EQ(faces_of(adjacency, vertices), (std::vector<int>{0, 1, 2}));
}

}  // namespace
}  // namespace planish
