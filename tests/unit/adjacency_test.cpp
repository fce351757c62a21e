// SPDX-License-Identifier: MIT
#include "planish/mesh/adjacency.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

std::vector<int> row(const RaggedRows& rows, int index) {
  const auto span = rows[index];
  return {span.begin(), span.end()};
}

std::set<int> row_set(const RaggedRows& rows, int index) {
  const auto span = rows[index];
  return {span.begin(), span.end()};
}

/// Whether consecutive neighbours of `vertex` share a face with it.
bool steps_cross_faces(const Mesh& mesh, const Adjacency& adjacency, int vertex, bool closed) {
  const std::vector<int> around = row(adjacency.neighbours, vertex);
  const std::size_t steps = around.size() - (closed ? 0 : 1);
  for (std::size_t k = 0; k < steps; ++k) {
    const int a = around[k], b = around[(k + 1) % around.size()];
    bool shared = false;
    for (const int f : adjacency.faces[vertex]) {
      const auto face = mesh.face(f);
      shared = shared || (std::count(face.begin(), face.end(), a) > 0 &&
                          std::count(face.begin(), face.end(), b) > 0);
    }
    if (!shared) return false;
  }
  return true;
}

TEST(Adjacency, GoesAroundAnInteriorVertexCrossingOneFaceAStep) {
  const Mesh mesh = testing::quad_grid(5, 5);
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_EQ(row_set(adjacency.neighbours, 12), (std::set<int>{7, 11, 13, 17}));
  EXPECT_TRUE(steps_cross_faces(mesh, adjacency, 12, true));
  EXPECT_FALSE(adjacency.boundary[12]);
  EXPECT_TRUE(adjacency.regular[12]);
  EXPECT_EQ(row_set(adjacency.faces, 12), (std::set<int>{5, 6, 9, 10}));
}

TEST(Adjacency, StartsAndEndsAFanAtTheBoundary) {
  const Mesh mesh = testing::quad_grid(5, 5);
  const Adjacency adjacency = build_adjacency(mesh);
  const std::vector<int> around = row(adjacency.neighbours, 2);
  ASSERT_EQ(around.size(), 3u);
  EXPECT_EQ(std::set<int>({around.front(), around.back()}), (std::set<int>{1, 3}));
  EXPECT_EQ(around[1], 7);
  EXPECT_TRUE(adjacency.boundary[2]);
  EXPECT_TRUE(adjacency.regular[2]);
  EXPECT_EQ(row_set(adjacency.neighbours, 0), (std::set<int>{1, 5}));
}

TEST(Adjacency, CountsEachNeighbourOnce) {
  for (const char* name : {"vault", "hex", "trihex"}) {
    const Mesh mesh = testing::sample(name, 12);
    const Adjacency adjacency = build_adjacency(mesh);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_EQ(row_set(adjacency.neighbours, v).size(), adjacency.neighbours[v].size()) << name;
      EXPECT_TRUE(
          steps_cross_faces(mesh, adjacency, v, !adjacency.boundary[static_cast<std::size_t>(v)]))
          << name << " vertex " << v;
    }
  }
}

TEST(Adjacency, IgnoresTheOrientationOfFaces) {
  Mesh mesh = testing::quad_grid(5, 5);
  for (const int f : {3, 6, 9, 14}) {
    const auto begin = mesh.face_vertices.begin() + mesh.face_offsets[static_cast<std::size_t>(f)];
    std::reverse(begin, begin + 4);
  }
  const Adjacency adjacency = build_adjacency(mesh);
  const Adjacency straight = build_adjacency(testing::quad_grid(5, 5));
  for (int v = 0; v < 25; ++v) {
    EXPECT_EQ(row_set(adjacency.neighbours, v), row_set(straight.neighbours, v));
    EXPECT_EQ(adjacency.boundary[static_cast<std::size_t>(v)],
              straight.boundary[static_cast<std::size_t>(v)]);
    EXPECT_TRUE(adjacency.regular[static_cast<std::size_t>(v)]);
    EXPECT_TRUE(
        steps_cross_faces(mesh, adjacency, v, !adjacency.boundary[static_cast<std::size_t>(v)]));
  }
}

TEST(Adjacency, MarksAPinchOfTwoFans) {
  const Mesh mesh = testing::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
      {{0, 1, 2, 3}, {2, 4, 5, 6}});
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_FALSE(adjacency.regular[2]);
  EXPECT_TRUE(adjacency.boundary[2]);
  EXPECT_EQ(row_set(adjacency.neighbours, 2), (std::set<int>{1, 3, 4, 6}));
  EXPECT_EQ(adjacency.neighbours[2].size(), 4u);
}

TEST(Adjacency, MarksAPinchOfTwoDisks) {
  // Two tetrahedra that touch at vertex 0.
  const Mesh mesh = testing::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}});
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_FALSE(adjacency.regular[0]);
  EXPECT_FALSE(adjacency.boundary[0]);
  EXPECT_EQ(adjacency.neighbours[0].size(), 6u);
  for (int v = 1; v < 7; ++v) EXPECT_TRUE(adjacency.regular[static_cast<std::size_t>(v)]);
}

TEST(Adjacency, LeavesAnIsolatedVertexAlone) {
  const Mesh mesh = testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {5, 5, 5}}, {{0, 1, 2}});
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_TRUE(adjacency.neighbours[3].empty());
  EXPECT_TRUE(adjacency.faces[3].empty());
  EXPECT_FALSE(adjacency.boundary[3]);
}

/// Two faces on the same two edges of a vertex (a valence-2 vertex in the interior).
TEST(Adjacency, ClosesADiskOfTwoFaces) {
  const Mesh mesh = testing::make_mesh({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}},
                                       {{0, 1, 2, 4}, {0, 4, 2, 3}});
  const Adjacency adjacency = build_adjacency(mesh);
  EXPECT_EQ(row_set(adjacency.neighbours, 4), (std::set<int>{0, 2}));
  EXPECT_EQ(adjacency.neighbours[4].size(), 2u);
  EXPECT_FALSE(adjacency.boundary[4]);
  EXPECT_TRUE(adjacency.regular[4]);
}

/// A cone of that many faces took time by the square once: ten minutes for a million.
TEST(Adjacency, GoesAroundTheTipOfACone) {
  constexpr int kFaces = 200'000;
  Mesh cone;
  cone.positions = Positions::Zero(3, kFaces + 1);
  for (int k = 0; k < kFaces; ++k) {
    cone.face_vertices.insert(cone.face_vertices.end(), {0, 1 + k, 1 + (k + 1) % kFaces});
    cone.face_offsets.push_back(static_cast<int>(cone.face_vertices.size()));
  }
  const Adjacency adjacency = build_adjacency(cone);
  const std::vector<int> around = row(adjacency.neighbours, 0);
  ASSERT_EQ(around.size(), static_cast<std::size_t>(kFaces));
  for (std::size_t k = 1; k < around.size(); ++k) {
    const int step = std::abs(around[k] - around[k - 1]);
    ASSERT_TRUE(step == 1 || step == kFaces - 1) << k;
  }
  EXPECT_EQ(std::set<int>(around.begin(), around.end()).size(), around.size());
  EXPECT_FALSE(adjacency.boundary[0]);
  EXPECT_TRUE(adjacency.regular[0]);
}

}  // namespace
}  // namespace planish
