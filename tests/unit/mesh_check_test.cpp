// SPDX-License-Identifier: MIT
#include "planish/mesh/mesh_check.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "planish/io/obj.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

using testing::error_text;
using testing::make_mesh;
using testing::shared_mesh_bytes;
using testing::warning_text;

/// n × n quads in the plane, vertex index j (n + 1) + i.
Mesh grid(int n) {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> faces;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) points.emplace_back(i, j, 0);
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      faces.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  }
  return make_mesh(points, faces);
}

TEST(MeshCheck, AcceptsACleanMeshWithoutAWord) {
  const Mesh mesh = grid(4);
  const ReadResult result = check_mesh(mesh);
  EXPECT_EQ(warning_text(result), "");
  EXPECT_TRUE(testing::same_bits(std::get<MeshFile>(result).mesh, mesh));
}

TEST(MeshCheck, RefusesWhatNoSolverCanUse) {
  Mesh mesh = grid(2);
  mesh.positions(1, 4) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_text(check_mesh(mesh)), "vertex 4 has the coordinate nan, which is not finite");
  mesh = grid(2);
  mesh.face_vertices[5] = 9;
  EXPECT_EQ(error_text(check_mesh(mesh)),
            "face 1 uses vertex 9, but the mesh has 9 vertices (from 0)");
  mesh.face_vertices[5] = -1;
  EXPECT_NE(error_text(check_mesh(mesh)), "");
  mesh = grid(2);
  mesh.positions.setConstant(3.0);
  EXPECT_EQ(error_text(check_mesh(mesh)), "all edges have length zero");
  EXPECT_EQ(error_text(check_mesh(make_mesh({{0, 0, 0}}, {}))), "the file holds no faces");
}

TEST(MeshCheck, NamesLinesWhereTheReaderKnowsThem) {
  Mesh mesh = grid(1);
  mesh.face_vertices[2] = 0;
  EXPECT_EQ(error_text(check_mesh(mesh, {{1, 2, 3, 4}, {17}})),
            "line 17: face 0 uses vertex 0 twice");
}

TEST(MeshCheck, NamesTwoFacesOfANonManifoldEdge) {
  const Mesh fan = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                             {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(error_text(check_mesh(fan)),
            "the edge between vertices 0 and 1 is shared by 3 faces, among them 0 and 2; an edge "
            "can have at most 2");
}

TEST(MeshCheck, CountsVerticesAndFacesAlikeAndAsTheFileDoes) {
  const Mesh fan = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                             {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(error_text(check_mesh(fan, {.vertices = {}, .faces = {6, 7, 8}, .first = 1})),
            "line 8: the edge between vertices 1 and 2 is shared by 3 faces, among them 1 and 3 "
            "(from 1); an edge can have at most 2");
}

TEST(MeshCheck, WarnsOfAFlippedFaceAndAPinch) {
  Mesh mesh = grid(2);
  std::swap(mesh.face_vertices[1], mesh.face_vertices[3]);
  EXPECT_EQ(warning_text(check_mesh(mesh)),
            "2 edges lie between faces of opposite orientation (first: faces 0 and 1); the faces "
            "are kept as they are; convert --orient turns them\n");
  const Mesh bow =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(warning_text(check_mesh(bow)),
            "1 vertex joins faces that share no edge there (first: vertex 0); they are kept as "
            "they are\n");
}

TEST(MeshCheck, SummaryCountsLoopsPiecesAndPinches) {
  const MeshSummary disk = summarize(grid(4));
  EXPECT_EQ(disk.boundary_loops, 1);
  EXPECT_EQ(disk.components, 1);
  EXPECT_EQ(disk.pinch_vertices, 0);
  EXPECT_EQ(disk.face_sizes, (std::map<int, int>{{4, 16}}));
  EXPECT_DOUBLE_EQ(disk.mean_edge, 1.0);
  const Mesh bow = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {9, 9, 9}},
                             {{0, 1, 2}, {0, 3, 4}});
  const MeshSummary pinched = summarize(bow);
  EXPECT_EQ(pinched.boundary_loops, 2);
  EXPECT_EQ(pinched.components, 1);
  EXPECT_EQ(pinched.pinch_vertices, 1);
  EXPECT_EQ(pinched.isolated_vertices, 1);
}

TEST(MeshCheck, SummaryCountsNonManifoldEdges) {
  const Mesh fan = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                             {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(summarize(fan).nonmanifold_edges, 1);
}

/// Loops and pieces of the shared meshes, as their README lists them.
TEST(MeshCheck, AgreesWithTheListOfSharedMeshes) {
  struct Expected {
    const char* name;
    int loops, components;
  };
  for (const Expected& expected : {Expected{"pq_gitter", 5, 1},
                                   Expected{"pq_octtorus", 0, 1},
                                   {"pq_six_planarized", 2, 1},
                                   Expected{"mixed345_airport", 2, 1},
                                   Expected{"hex_sphere_two_openings", 2, 1},
                                   Expected{"nasty/real_five_components", 0, 5},
                                   Expected{"nasty/moebius_quads", 1, 1}}) {
    const auto bytes = shared_mesh_bytes(std::string(expected.name) + ".obj");
    if (!bytes) GTEST_SKIP() << "skipped: no shared meshes";
    const ReadResult result = read_obj(*bytes);
    ASSERT_EQ(error_text(result), "") << expected.name;
    const MeshSummary summary = summarize(std::get<MeshFile>(result).mesh);
    EXPECT_EQ(summary.boundary_loops, expected.loops) << expected.name;
    EXPECT_EQ(summary.components, expected.components) << expected.name;
  }
}

/// A fan of many triangles around one vertex must not cost its square.
TEST(MeshCheck, AVertexOfHugeValenceIsQuick) {
  constexpr int kCount = 200000;
  std::vector<Eigen::Vector3d> points{{0, 0, 0}};
  std::vector<std::vector<int>> faces;
  for (int k = 0; k < kCount; ++k) points.emplace_back(k, 1.0, k % 7);
  for (int k = 1; k < kCount; ++k) faces.push_back({0, k, k + 1});
  EXPECT_EQ(warning_text(check_mesh(make_mesh(points, faces))), "");
}

}  // namespace
}  // namespace planish
