// SPDX-License-Identifier: MIT
#include "planish/problem/edit_freedom.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "planish/measures/metrics.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

EditFreedom freedom_of(const Mesh& mesh, const std::vector<int>& free,
                       const std::vector<Pull>& pulls = {}) {
  const auto found = measure_freedom(mesh, build_adjacency(mesh), mesh.positions, free, pulls);
  EXPECT_TRUE(found.has_value());
  return found.value_or(EditFreedom{});
}

std::vector<int> all_vertices(const Mesh& mesh) {
  std::vector<int> all(static_cast<std::size_t>(mesh.vertex_count()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TEST(EditFreedom, OfASamplePatchIsTheCountedOne) {
  for (const char* name : {"vault", "dome", "hex", "trihex"}) {
    const Mesh mesh = testing::sample(name, 7);
    const EditFreedom whole = freedom_of(mesh, all_vertices(mesh));
    EXPECT_EQ(whole.freedom(), degrees_of_freedom(mesh)) << name;
    EXPECT_EQ(whole.rank, whole.equations) << name;
  }
}

TEST(EditFreedom, DependentEquationsCountOnce) {
  // One quad that appears twice: two equations, one condition.
  const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Mesh mesh = testing::make_mesh(corners, {{0, 1, 2, 3}, {0, 1, 2, 3}});
  const EditFreedom found = freedom_of(mesh, all_vertices(mesh));
  EXPECT_EQ(found.equations, 2);
  EXPECT_EQ(found.rank, 1);
  EXPECT_EQ(found.freedom(), 11);
}

TEST(EditFreedom, TrianglesHoldNothing) {
  const Mesh mesh = testing::triangle_grid(4, 4);
  const EditFreedom found = freedom_of(mesh, {5, 6}, {{5, {0, 0, 1}}});
  EXPECT_EQ(found.equations, 0);
  EXPECT_EQ(found.freedom(), 6);
  EXPECT_TRUE(found.holding.empty());
}

TEST(EditFreedom, NamesThePanelsThatHoldAPoint) {
  // The middle of a curved grid, alone: its four quads let it go nowhere.
  const Mesh mesh = testing::sample("vault", 9);
  const int middle = 4 * 9 + 4;
  const EditFreedom found = freedom_of(mesh, {middle}, {{middle, {0, 0, 1}}});
  EXPECT_EQ(found.points, 1);
  EXPECT_EQ(found.equations, 4);
  EXPECT_EQ(found.rank, 3);
  EXPECT_EQ(found.freedom(), 0);
  EXPECT_NEAR(found.borne, 1.0, 1e-9);
  ASSERT_FALSE(found.holding.empty());
  for (const HoldingPanel& panel : found.holding) {
    const auto face = mesh.face(panel.face);
    EXPECT_NE(std::find(face.begin(), face.end(), middle), face.end());
    EXPECT_LE(panel.share, found.holding.front().share);
  }
}

TEST(EditFreedom, APullAlongAFreeDirectionIsNotBorne) {
  // In a flat grid a point slides in the plane and is held out of it.
  const Mesh mesh = testing::quad_grid(5, 5);
  EXPECT_NEAR(freedom_of(mesh, {12}, {{12, {1, 2, 0}}}).borne, 0.0, 1e-12);
  EXPECT_NEAR(freedom_of(mesh, {12}, {{12, {0, 0, 1}}}).borne, 1.0, 1e-12);
  EXPECT_NEAR(freedom_of(mesh, {12}, {{12, {3, 0, 4}}}).borne, 0.8, 1e-12);
  EXPECT_TRUE(freedom_of(mesh, {12}, {{13, {0, 0, 1}}}).holding.empty());
}

TEST(EditFreedom, DoesNotFactorWhatIsTooLarge) {
  const Mesh mesh = testing::sample("vault", 40);
  const auto found =
      measure_freedom(mesh, build_adjacency(mesh), mesh.positions, all_vertices(mesh), {});
  EXPECT_FALSE(found.has_value());
}

}  // namespace
}  // namespace planish
