// SPDX-License-Identifier: MIT
// Meshes of which is known how few types they can have.
#include "planish/repetition/fewer_types.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "planish/measures/metrics.hpp"
#include "planish/projection/projection.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// Quads on a cylinder, all of them the same, and then each point a little elsewhere, flat again.
Mesh uneven_barrel(int size, double noise) {
  std::vector<Eigen::Vector3d> points;
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) {
      const double angle = 0.1 * i;
      points.emplace_back(10.0 * std::sin(angle), j, 10.0 * std::cos(angle));
    }
  }
  Mesh mesh = testing::quad_grid(size, size);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    mesh.positions.col(v) = points[static_cast<std::size_t>(v)];
  }
  mesh.positions += noise * testing::random_points(7, mesh.vertex_count());
  const ProjectionResult flat = project_to_planar(mesh);
  mesh.positions(Eigen::all, flat.moved) = flat.moved_positions;
  return mesh;
}

FewerTypesOptions barrel_options(const Mesh& mesh) {
  FewerTypesOptions options;
  options.within = 0.005 * mean_edge_length(mesh);
  options.move = 0.2 * mean_edge_length(mesh);
  return options;
}

TEST(FewerTypes, FindTheOneTypeOfAnUnevenBarrel) {
  const Mesh mesh = uneven_barrel(9, 0.01);
  const FewerTypesOptions options = barrel_options(mesh);
  const FewerTypes fewer = find_fewer_types(mesh, options, {});
  EXPECT_GT(fewer.before, 20);
  EXPECT_EQ(fewer.types.families.size(), 1u);
  EXPECT_LE(fewer.types.families[0].worst, options.within);
  EXPECT_LE(fewer.max_move, options.move);
  EXPECT_GT(fewer.max_move, 0.0);
  EXPECT_LE(planarity_summary(mesh, fewer.positions).max_excess, testing::kPromise);
  EXPECT_TRUE(fewer.reached);
  EXPECT_FALSE(fewer.merging);
}

TEST(FewerTypes, LeaveAMeshOfOneTypeAsItIs) {
  const Mesh mesh = testing::quad_grid(6, 6);
  const FewerTypes fewer = find_fewer_types(mesh, barrel_options(mesh), {});
  EXPECT_EQ(fewer.before, 1);
  EXPECT_TRUE(testing::same_bits(fewer.positions, mesh.positions));
}

TEST(FewerTypes, AreAsManyAsAreAskedForWithinTheDistanceTold) {
  const Mesh mesh = uneven_barrel(7, 0.01);
  FewerTypesOptions options = barrel_options(mesh);
  options.within = 0.0;
  options.most_types = 3;
  const FewerTypes fewer = find_fewer_types(mesh, options, {});
  EXPECT_TRUE(fewer.reached);
  EXPECT_LE(fewer.types.families.size(), 3u);
  EXPECT_GT(fewer.before, 3);
  EXPECT_LT(fewer.within, 0.005 * mean_edge_length(mesh));
  for (const Family& type : fewer.types.families) EXPECT_LE(type.worst, fewer.within);
}

TEST(FewerTypes, StopWithTheBestSoFar) {
  const Mesh mesh = uneven_barrel(7, 0.01);
  const FewerTypes fewer = find_fewer_types(mesh, barrel_options(mesh), {},
                                            [](const IterationRecord&) { return Flow::kStop; });
  EXPECT_TRUE(fewer.cancelled);
  EXPECT_TRUE(testing::same_bits(fewer.positions, mesh.positions));
}

TEST(FewerTypes, NameTheFieldThatIsWrong) {
  const Mesh mesh = testing::three_panels();
  FewerTypesOptions options;
  EXPECT_EQ(find_problem(options), "within must be greater than 0");
  options.most_types = 2;
  EXPECT_EQ(find_problem(options), "move must be greater than 0");
  options.move = 0.1;
  EXPECT_EQ(find_problem(options), std::nullopt);
  options.tolerance = 1e3;
  EXPECT_EQ(find_problem(options, mesh),
            "panels have 3 different numbers of corners: there are at least as many types");
  options.tolerance = 1e-6;
  EXPECT_EQ(find_problem(options, mesh), "the mesh is not flat: planish project makes it so");
}

}  // namespace
}  // namespace planish
