// SPDX-License-Identifier: MIT
#include "engines/working_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/scenes.hpp"

namespace planish {
namespace {

class GrowsOn : public ::testing::TestWithParam<const char*> {};

TEST_P(GrowsOn, ExactlyTheFaceRingsOfItsSeeds) {
  const Mesh mesh = testing::sample(GetParam(), 12);
  const MeshModel model(mesh, FairnessKind::kLaplacian);
  WorkingSetGrower grower(model);
  for (const int v : {0, testing::middle_vertex(mesh), mesh.vertex_count() - 1}) {
    for (int rings = 0; rings <= 4; ++rings) {
      const std::vector<int> seed{v};
      EXPECT_EQ(grower.grow(seed, rings), testing::ring_neighbourhood(mesh, v, rings));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, GrowsOn, ::testing::Values("vault", "hex", "trihex"));

TEST(WorkingSetGrower, MergesSeedsWithoutDuplicates) {
  const MeshModel model(testing::quad_grid(7, 7), FairnessKind::kLaplacian);
  WorkingSetGrower grower(model);
  const std::vector<int> seeds{24, 8, 24, 9};
  const std::vector<int> grown = grower.grow(seeds, 1);
  EXPECT_TRUE(std::is_sorted(grown.begin(), grown.end()));
  EXPECT_EQ(std::adjacent_find(grown.begin(), grown.end()), grown.end());
  EXPECT_EQ(grown.size(), 12u + 9u - 2u);  // 3 × 4 and 3 × 3, which share vertices 16 and 17
  EXPECT_TRUE(grower.grow({}, 3).empty());
  EXPECT_EQ(grower.grow(seeds, 50).size(), 49u);
}

TEST(WorkingSetGrower, FollowsTheGridLinesThroughAVertex) {
  const MeshModel model(testing::quad_grid(9, 9), FairnessKind::kLaplacian);
  const WorkingSetGrower grower(model);
  std::vector<int> line = grower.lines_through(40, 2);
  std::sort(line.begin(), line.end());
  EXPECT_EQ(line, (std::vector<int>{22, 31, 38, 39, 40, 41, 42, 49, 58}));
  line = grower.lines_through(40, 100);
  EXPECT_EQ(line.size(), 17u) << "both lines, up to the boundary";
}

TEST(WorkingSetGrower, FindsNoLineAtAVertexOfOddValence) {
  const Mesh mesh = testing::sample("hex", 12);
  const MeshModel model(mesh, FairnessKind::kLaplacian);
  EXPECT_TRUE(WorkingSetGrower(model).lines_through(testing::middle_vertex(mesh), 8).empty());
}

}  // namespace
}  // namespace planish
