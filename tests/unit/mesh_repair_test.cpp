// SPDX-License-Identifier: MIT
#include "planish/mesh/mesh_repair.hpp"

#include <gtest/gtest.h>

#include <string>

#include "planish/io/obj.hpp"
#include "support/mesh_builders.hpp"

namespace planish {
namespace {

using testing::error_text;
using testing::make_mesh;
using testing::shared_mesh_bytes;
using testing::warning_text;

/// Two squares side by side, and a point in the middle of the edge between them.
const std::vector<Eigen::Vector3d> kPoints = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0},
                                              {1, 2, 0}, {2, 2, 0}, {1, 1, 0}};

std::vector<std::vector<int>> faces_of(const ReadResult& result) {
  std::vector<std::vector<int>> faces;
  const Mesh& mesh = std::get<MeshFile>(result).mesh;
  for (int f = 0; f < mesh.face_count(); ++f) {
    faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  }
  return faces;
}

using Faces = std::vector<std::vector<int>>;

TEST(MeshRepair, ACornerNamedTwiceIsReadOnce) {
  for (const std::vector<int>& face : Faces{{0, 1, 1, 4, 3}, {0, 0, 1, 4, 3}, {0, 1, 4, 3, 0}}) {
    const ReadResult result = repair_and_check(make_mesh(kPoints, {{1, 2, 5, 4}, face}));
    EXPECT_EQ(faces_of(result), (Faces{{1, 2, 5, 4}, {0, 1, 4, 3}}));
    EXPECT_EQ(warning_text(result).substr(0, 61),
              "1 face names a corner twice (first: face 1); it is read once\n");
  }
}

TEST(MeshRepair, AnEdgeGoneThereAndBackIsNoCorner) {
  const Faces there_and_back = {
      {0, 1, 6, 1, 4, 3}, {6, 1, 4, 3, 0, 1}, {1, 4, 3, 0, 1, 6}, {0, 1, 6, 2, 6, 1, 4, 3}};
  for (const std::vector<int>& face : there_and_back) {
    const ReadResult result = repair_and_check(make_mesh(kPoints, {face}));
    const Faces faces = faces_of(result);
    ASSERT_EQ(faces.size(), 1u);
    EXPECT_EQ(faces[0].size(), 4u);
  }
}

TEST(MeshRepair, FacesWithoutThreeCornersAreLeftOut) {
  const Mesh mesh = make_mesh(kPoints, {{0, 0, 1, 1}, {1, 2, 5, 4}, {3, 4, 3}, {0, 1, 4, 3}});
  const ReadResult result =
      repair_and_check(mesh, {.vertices = {}, .faces = {11, 12, 13, 14}, .first = 1});
  EXPECT_EQ(faces_of(result), (Faces{{1, 2, 5, 4}, {0, 1, 4, 3}}));
  EXPECT_EQ(warning_text(result).substr(0, 139),
            "2 faces have fewer than 3 different corners (first: line 11); left out, so panels "
            "after them have lower numbers and names than in the file\n");
}

TEST(MeshRepair, TrianglesWithoutAreaStayAndAreNamed) {
  const Mesh mesh = make_mesh(kPoints, {{0, 1, 6, 4, 3}, {1, 4, 6}, {1, 2, 5, 4}});
  const ReadResult result = repair_and_check(mesh);
  EXPECT_TRUE(testing::same_bits(std::get<MeshFile>(result).mesh, mesh));
  EXPECT_EQ(warning_text(result),
            "1 face encloses no area (first: face 1); they are kept as they are\n");
}

TEST(MeshRepair, WhatIsNotHarmlessIsRefusedByItsOwnNumbers) {
  const Mesh eight = make_mesh(kPoints, {{0, 0, 1}, {0, 1, 6, 0, 4, 6}});
  EXPECT_EQ(error_text(repair_and_check(eight, {.vertices = {}, .faces = {8, 9}, .first = 1})),
            "line 9: face 2 uses vertex 1 twice (from 1)");
  EXPECT_EQ(error_text(repair_and_check(make_mesh(kPoints, {{0, 0, 1}}))),
            "the file holds no faces");
  EXPECT_EQ(error_text(repair_and_check(make_mesh(kPoints, {{0, 0, 1}, {0, 1, 9}}))),
            "face 1 uses vertex 9, but the mesh has 7 vertices (from 0)");
}

TEST(MeshRepair, GroupsKeepTheirFaces) {
  Mesh mesh = make_mesh(kPoints, {{0, 0, 1}, {1, 2, 5, 4}, {3, 4, 3}, {0, 1, 4, 3}, {2, 2, 5}});
  mesh.groups = {{"none", 0}, {"right", 1}, {"left", 2}, {"gone", 4}};
  const ReadResult result = repair_and_check(mesh);
  const std::vector<FaceGroup>& groups = std::get<MeshFile>(result).mesh.groups;
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].name, "right");
  EXPECT_EQ(groups[0].first_face, 0);
  EXPECT_EQ(groups[1].name, "left");
  EXPECT_EQ(groups[1].first_face, 1);
}

TEST(MeshRepair, AMeshWithoutFaultsKeepsItsBits) {
  const Mesh mesh = make_mesh(kPoints, {{0, 1, 6, 4, 3}, {1, 2, 5, 4, 6}});
  const ReadResult result = repair_and_check(mesh);
  EXPECT_TRUE(testing::same_bits(std::get<MeshFile>(result).mesh, mesh));
  EXPECT_EQ(warning_text(result), "");
}

TEST(MeshRepair, AFileWithARepeatedCornerOpens) {
  const auto bytes = shared_mesh_bytes("nasty/repeated_index_face.obj");
  if (!bytes) GTEST_SKIP() << "no shared meshes";
  const ReadResult result = read_obj(*bytes);
  EXPECT_NE(warning_text(result).find("(first: line 42)"), std::string::npos)
      << warning_text(result) << error_text(result);
}

}  // namespace
}  // namespace planish
