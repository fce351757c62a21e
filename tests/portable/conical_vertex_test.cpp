// SPDX-License-Identifier: MIT
#include "planish/constraints/conical_vertex.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "planish/constraints/conical_star.hpp"
#include "planish/constraints/kept_kinds.hpp"
#include "planish/problem/problem.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

const std::vector<int> kStar{0, 1, 2, 3, 4};

/// The apex of planes that touch one cone of revolution, at uneven places around it, and a point of
/// each of the lines in which neighbouring planes meet. @param tilted the first plane, by degrees
Positions apex_of_touching_planes(const std::vector<double>& degrees, double tilted = 0.0) {
  std::vector<Eigen::Vector3d> normals;
  const double slope = std::atan2(0.7, 1.0);
  for (const double angle : degrees) {
    const double t = angle * std::numbers::pi / 180.0;
    const double tilt = slope + (normals.empty() ? tilted * std::numbers::pi / 180.0 : 0.0);
    normals.emplace_back(std::cos(t) * std::cos(tilt), std::sin(t) * std::cos(tilt),
                         std::sin(tilt));
  }
  const std::size_t count = degrees.size();
  Positions star = Positions::Zero(3, static_cast<Eigen::Index>(count) + 1);
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector3d line = normals[k].cross(normals[(k + 1) % count]);
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

std::vector<int> star_of_valence(std::size_t valence) {
  std::vector<int> star(valence + 1);
  std::iota(star.begin(), star.end(), 0);
  return star;
}

/// [CV-3]
TEST(StarDefect, IsZeroOnAConeOfRevolution) {
  const std::vector<double> places{0, 50, 120, 180, 230, 300, 335};
  for (std::size_t valence = 5; valence <= places.size(); ++valence) {
    const std::vector<double> some(places.begin(), places.begin() + static_cast<int>(valence));
    EXPECT_LT(star_defect(apex_of_touching_planes(some), star_of_valence(valence)), 1e-11);
  }
}

/// About the angle by which a plane is off the cone of the others.
TEST(StarDefect, IsTheAngleOffTheCone) {
  for (const double first : {0.0, 40.0, 100.0, 200.0, 310.0}) {
    std::vector<double> places{first};
    for (const double step : {50, 110, 185, 240, 310}) places.push_back(first + step);
    const double defect = star_defect(apex_of_touching_planes(places, 1.0), star_of_valence(6));
    EXPECT_GT(defect, 0.5);
    EXPECT_LT(defect, 3.0);
  }
  EXPECT_EQ(star_defect(apex_of_touching_planes({0, 90, 180, 270}), kStar), 0.0);
}

/// Three planes in a row that fall together meet a cone with any fourth, not with all.
TEST(StarDefect, IsNotZeroWhereNeighboursAreOnePlane) {
  const std::vector<double> places{0, 0.001, 0.002, 120, 120.001, 240, 240.001};
  EXPECT_GT(star_defect(apex_of_touching_planes(places, 2.0), star_of_valence(7)), 0.5);
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
  kept.keep("conical", 1e-9);
  const MeshModel quads(testing::sample("vault", 8), FairnessKind::kLaplacian, kept);
  EXPECT_EQ(quads.equations.of<ConicalVertex>().size(), 36u);
  const MeshModel hexagons(testing::sample("hex", 8), FairnessKind::kLaplacian, kept);
  EXPECT_TRUE(hexagons.equations.of<ConicalVertex>().empty());
}

/// A patch has every row of a star that touches it, and no other.
TEST(ConeEquation, OfAPatchAreThoseThatItsVerticesTouch) {
  KeptKinds kept;
  kept.keep("conical", 1e-9);
  const Mesh mesh = testing::sample("vault", 12);
  const MeshModel model(mesh, FairnessKind::kSecondDifference, kept);
  EditProblem problem;
  problem.model = &model;
  problem.terms.resize(static_cast<std::size_t>(mesh.vertex_count()));
  PatchCutter cutter(model);
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
