// SPDX-License-Identifier: MIT
#include "planish/constraints/conical_vertex.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "planish/constraints/kept_kinds.hpp"
#include "planish/problem.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

const std::vector<int> kStar{0, 1, 2, 3, 4};

/// The apex of four planes that touch one cone of revolution, at uneven places around it, and a
/// point of each of the four lines in which neighbouring planes meet.
Positions apex_of_touching_planes(const std::vector<double>& degrees) {
  std::vector<Eigen::Vector3d> normals;
  for (const double angle : degrees) {
    const double t = angle * std::numbers::pi / 180.0;
    normals.emplace_back(std::cos(t), std::sin(t), 0.7);
  }
  Positions star = Positions::Zero(3, 5);
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector3d line = normals[k].cross(normals[(k + 1) % 4]);
    star.col(static_cast<Eigen::Index>(k + 1)) =
        (line.z() < 0.0 ? -1.0 : 1.0) * (1.0 + 0.3 * static_cast<double>(k)) * line.normalized();
  }
  return star;
}

/// [CV-1]
TEST(ConeDefect, IsZeroOnAConeOfRevolution) {
  EXPECT_LT(cone_defect(apex_of_touching_planes({0, 80, 190, 260}), kStar), 1e-12);
  EXPECT_LT(cone_defect(apex_of_touching_planes({10, 100, 170, 275}), kStar), 1e-12);
}

TEST(ConeDefect, IsWhatTheAnglesMiss) {
  Positions star(3, 5);  // flat, at 0°, 80°, 170° and 270°: 80 − 90 + 100 − 90
  star.setZero();
  const double angles[] = {0.0, 80.0, 170.0, 270.0};
  for (int k = 0; k < 4; ++k) {
    const double t = angles[k] * std::numbers::pi / 180.0;
    star.col(k + 1) = Eigen::Vector3d(2.0 * std::cos(t), 2.0 * std::sin(t), 0.0);
  }
  EXPECT_NEAR(cone_defect(star, kStar), 0.0, 1e-12);
  star.col(2) = Eigen::Vector3d(0.0, 1.0, 1.0);
  EXPECT_GT(cone_defect(star, kStar), 1.0);
  EXPECT_EQ(cone_defect(star, std::vector<int>{0, 1, 2, 3}), 0.0);
}

TEST(ConeEquation, HangsOnInnerVerticesOfValenceFourAlone) {
  KeptKinds kept;
  kept.keep(*kind_index("conical"), 1e-9);
  const MeshModel quads(testing::sample("vault", 8), FairnessKind::kLaplacian, kept);
  EXPECT_EQ(quads.equations.of<ConicalVertex>().size(), 36u);
  const MeshModel hexagons(testing::sample("hex", 8), FairnessKind::kLaplacian, kept);
  EXPECT_TRUE(hexagons.equations.of<ConicalVertex>().empty());
}

/// A patch has every row of a star that touches it, and no other.
TEST(ConeEquation, OfAPatchAreThoseThatItsVerticesTouch) {
  KeptKinds kept;
  kept.keep(*kind_index("conical"), 1e-9);
  const Mesh mesh = testing::sample("vault", 12);
  const MeshModel model(mesh, FairnessKind::kSecondDifference, kept);
  EditProblem problem;
  problem.model = &model;
  problem.terms.resize(static_cast<std::size_t>(mesh.vertex_count()));
  PatchCutter cutter(mesh.vertex_count(), mesh.face_count(),
                     static_cast<int>(model.fairness.rows()));
  Patch patch;
  cutter.cut(problem, std::vector<int>{6 * 12 + 6}, patch);
  EXPECT_EQ(patch.equations.of<ConicalVertex>().size(), 5u);
  EXPECT_EQ(patch.equations.of<PlanarPolygon>().size(), 4u);
  for (const ConeEquation& row : patch.equations.of<ConicalVertex>()) {
    EXPECT_NE(std::count(row.vertices.begin(), row.vertices.end(), 0), 0);
    for (const int v : row.vertices) EXPECT_LT(v, patch.local_count());
  }
}

}  // namespace
}  // namespace planish
