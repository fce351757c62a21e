// SPDX-License-Identifier: MIT
/// Merged panels and strips that go: flat and sound around, nothing else moves, or one sentence.
#include "planish/splitting/fewer_panels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "support/record.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr int kReach = 2;

/// The corners of what changed, and of `rings` rings of panels around.
std::set<int> around(const Mesh& mesh, std::vector<int> points, int rings) {
  const Adjacency adjacency = build_adjacency(mesh);
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<int> faces = faces_of(adjacency, points);
    for (const int f : faces) points.insert(points.end(), mesh.face(f).begin(), mesh.face(f).end());
  }
  return {points.begin(), points.end()};
}

void expect_local_and_flat(const Mesh& mesh, const FewerPanels& fewer, const std::set<int>& near) {
  EXPECT_LE(planarity_summary(fewer.mesh).max_excess, 1e-6);
  EXPECT_TRUE(std::holds_alternative<MeshFile>(check_mesh(fewer.mesh)));
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const bool same = fewer.mesh.positions.col(v) == mesh.positions.col(v);
    EXPECT_TRUE(same || near.count(v) == 1) << v;
    EXPECT_EQ(same, !std::binary_search(fewer.moved.begin(), fewer.moved.end(), v)) << v;
  }
  EXPECT_EQ(summarize(fewer.mesh).nonmanifold_edges, summarize(mesh).nonmanifold_edges);
}

/// Two panels with a side in common, and that side.
struct Pair {
  int first = 0, second = 0, from = 0, to = 0;
};

Pair random_pair(const Mesh& mesh, const Adjacency& adjacency, std::mt19937& random) {
  for (;;) {
    const int f = static_cast<int>(random() % static_cast<unsigned>(mesh.face_count()));
    const auto corners = mesh.face(f);
    const std::size_t k = random() % corners.size();
    const int from = corners[k], to = corners[(k + 1) % corners.size()];
    for (const int g : adjacency.faces[from]) {
      const auto other = mesh.face(g);
      if (g != f && std::find(other.begin(), other.end(), to) != other.end()) {
        return {f, g, from, to};
      }
    }
  }
}

const std::vector<std::pair<std::string, int>> kMeshes = {
    {"vault", 12}, {"dome", 12}, {"freeform", 12}, {"roof", 12}, {"hex", 10}, {"trihex", 10}};
/// 102 of each over all meshes.
constexpr int kEach = 17;

TEST(FewerPanelsOf, RandomMergesAreFlatAndLocalOrRefused) {
  std::mt19937 random(38);
  int made = 0;
  for (const auto& [name, size] : kMeshes) {
    const Mesh mesh = testing::sample(name, size);
    const Adjacency adjacency = build_adjacency(mesh);
    for (int k = 0; k < kEach; ++k) {
      SCOPED_TRACE(name + " " + std::to_string(k));
      const Pair pair = random_pair(mesh, adjacency, random);
      const auto result = merge_panels(mesh, pair.first, pair.second, {kReach});
      if (const auto* why = std::get_if<std::string>(&result)) {
        EXPECT_FALSE(why->empty());
        EXPECT_EQ(why->find('\n'), std::string::npos);
        continue;
      }
      ++made;
      const auto& fewer = std::get<FewerPanels>(result);
      EXPECT_EQ(fewer.mesh.face_count(), mesh.face_count() - 1);
      std::vector<int> corners(mesh.face(pair.first).begin(), mesh.face(pair.first).end());
      corners.insert(corners.end(), mesh.face(pair.second).begin(), mesh.face(pair.second).end());
      expect_local_and_flat(mesh, fewer, around(mesh, corners, kReach));
    }
  }
  testing::record("merges made of 102", made);
  EXPECT_GE(made, 95);
}

TEST(FewerPanelsOf, RandomCollapsesAreFlatAndLocalOrRefused) {
  std::mt19937 random(39);
  int made = 0;
  for (const auto& [name, size] : kMeshes) {
    const Mesh mesh = testing::sample(name, size);
    const Adjacency adjacency = build_adjacency(mesh);
    for (int k = 0; k < kEach; ++k) {
      SCOPED_TRACE(name + " " + std::to_string(k));
      const Pair pair = random_pair(mesh, adjacency, random);
      const auto result = collapse_strip(mesh, pair.from, pair.to, {kReach});
      if (const auto* why = std::get_if<std::string>(&result)) {
        EXPECT_FALSE(why->empty());
        EXPECT_EQ(why->find('\n'), std::string::npos);
        continue;
      }
      ++made;
      const auto& fewer = std::get<FewerPanels>(result);
      EXPECT_LT(fewer.mesh.face_count(), mesh.face_count());
      std::vector<int> gone;
      std::vector<char> left(static_cast<std::size_t>(mesh.face_count()), 0);
      for (const int f : fewer.parents) left[static_cast<std::size_t>(f)] = 1;
      for (int f = 0; f < mesh.face_count(); ++f) {
        if (left[static_cast<std::size_t>(f)] != 0) continue;
        gone.insert(gone.end(), mesh.face(f).begin(), mesh.face(f).end());
      }
      expect_local_and_flat(mesh, fewer, around(mesh, gone, kReach));
    }
  }
  testing::record("collapses made of 102", made);
  EXPECT_GE(made, 60);
}

TEST(FewerPanels, OfAFlatGridMoveNothingWhereTheyMerge) {
  Mesh mesh;
  mesh.positions.resize(3, 6);
  mesh.positions << 0, 1, 2, 0, 1, 2, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0;
  mesh.face_vertices = {0, 1, 4, 3, 1, 2, 5, 4};
  mesh.face_offsets = {0, 4, 8};
  mesh.groups = {{"left", 0}, {"right", 1}, {"none", 2}};
  const auto merged = std::get<FewerPanels>(merge_panels(mesh, 1, 0, {}));
  EXPECT_EQ(merged.mesh.face_count(), 1);
  EXPECT_EQ(merged.mesh.face(0).size(), 6U);
  EXPECT_EQ(merged.parents, std::vector<int>{1});
  // One that begins behind the last panel has none, as before.
  ASSERT_EQ(merged.mesh.groups.size(), 3U);
  EXPECT_EQ(merged.mesh.groups.back().first_face, 1);
  EXPECT_TRUE(merged.moved.empty());
  const auto gone = std::get<FewerPanels>(collapse_strip(mesh, 0, 1, {}));
  EXPECT_EQ(gone.mesh.face_count(), 1);
  EXPECT_EQ(gone.mesh.face(0).size(), 4U);
}

TEST(FewerPanels, AreRefusedInOneSentence) {
  const Mesh mesh = testing::sample("vault", 6);
  for (const auto& result :
       {merge_panels(mesh, 0, 0, {}), merge_panels(mesh, 0, 999, {}), merge_panels(mesh, 0, 24, {}),
        collapse_strip(mesh, 0, 35, {}), collapse_strip(mesh, 0, 99, {})}) {
    ASSERT_TRUE(std::holds_alternative<std::string>(result));
    EXPECT_EQ(std::get<std::string>(result).find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace planish
