// SPDX-License-Identifier: MIT
#include "planish/mesh/triangle_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "planish/io/obj.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using Faces = std::vector<std::vector<int>>;

Faces faces_of(const Mesh& mesh) {
  Faces faces;
  for (int f = 0; f < mesh.face_count(); ++f) {
    faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  }
  return faces;
}

Mesh with_faces(const Mesh& mesh, const Faces& faces) {
  std::vector<Eigen::Vector3d> points;
  for (int v = 0; v < mesh.vertex_count(); ++v) points.emplace_back(mesh.positions.col(v));
  return testing::make_mesh(points, faces);
}

/// Every quad as two triangles, one after the other; `other` chooses the diagonal by face.
template <class Choose>
Mesh split(const Mesh& mesh, Choose other) {
  Faces faces;
  for (const std::vector<int>& q : faces_of(mesh)) {
    if (q.size() != 4) {
      faces.push_back(q);
    } else if (other(faces.size())) {
      faces.push_back({q[0], q[1], q[3]});
      faces.push_back({q[1], q[2], q[3]});
    } else {
      faces.push_back({q[0], q[1], q[2]});
      faces.push_back({q[0], q[2], q[3]});
    }
  }
  return with_faces(mesh, faces);
}

/// Quads as sets of corners.
Faces corner_sets(const Mesh& mesh) {
  Faces sets = faces_of(mesh);
  for (std::vector<int>& set : sets) std::sort(set.begin(), set.end());
  std::sort(sets.begin(), sets.end());
  return sets;
}

TEST(JoinTriangles, GivesBackTheQuadsThatAProgramSplit) {
  for (const std::string name : {"vault", "roof", "dome"}) {
    const Mesh mesh = testing::sample(name, 12);
    const Mesh fans = split(mesh, [](std::size_t) { return false; });
    const Mesh both = split(mesh, [](std::size_t f) { return f % 4 == 0; });
    const auto is_quad = [](const std::vector<int>& face) { return face.size() == 4; };
    const Faces before = faces_of(mesh);
    if (!std::all_of(before.begin(), before.end(), is_quad)) continue;
    EXPECT_TRUE(testing::same_bits(join_triangles(fans), mesh)) << name;
    EXPECT_EQ(corner_sets(join_triangles(both)), corner_sets(mesh)) << name;
  }
}

TEST(JoinTriangles, FindsThemInAnyOrder) {
  std::mt19937 random(7);
  for (const std::string name : {"vault", "roof"}) {
    const Mesh mesh = testing::sample(name, 12);
    Faces faces = faces_of(split(mesh, [](std::size_t f) { return f % 4 == 0; }));
    std::shuffle(faces.begin(), faces.end(), random);
    const Mesh joined = join_triangles(with_faces(mesh, faces));
    Faces known = corner_sets(mesh), found = corner_sets(joined), both;
    std::set_intersection(known.begin(), known.end(), found.begin(), found.end(),
                          std::back_inserter(both));
    EXPECT_EQ(both.size(), known.size()) << name;
    EXPECT_TRUE(testing::same_bits(joined.positions, mesh.positions));
  }
}

TEST(JoinTriangles, LeavesOtherFacesAndWhatMakesNoQuad) {
  const std::vector<Eigen::Vector3d> points = {{0, 0, 0},   {1, 0, 0}, {1, 1, 0},    {0, 1, 0},
                                               {2, 0.5, 0}, {2, 0, 0}, {1.2, 0.3, 3}};
  // A square beside a triangle: both stay. Then two halves of a dart, and two across a sharp fold.
  EXPECT_EQ(faces_of(join_triangles(testing::make_mesh(points, {{0, 1, 2, 3}, {1, 4, 2}}))),
            (Faces{{0, 1, 2, 3}, {1, 4, 2}}));
  EXPECT_EQ(join_triangles(testing::make_mesh(points, {{0, 1, 2}, {1, 5, 2}})).face_count(), 2);
  EXPECT_EQ(join_triangles(testing::make_mesh(points, {{0, 1, 3}, {1, 6, 3}})).face_count(), 2);
}

TEST(JoinTriangles, StaysWithinGroups) {
  const Mesh mesh = testing::quad_grid(3, 3);
  Mesh fans = split(mesh, [](std::size_t) { return false; });
  fans.groups = {{"one", 0}, {"rest", 3}};
  const Mesh joined = join_triangles(fans);
  ASSERT_EQ(joined.groups.size(), 2u);
  EXPECT_EQ(joined.groups[1].name, "rest");
  int corners = 0;
  for (int f = 0; f < joined.groups[1].first_face; ++f) {
    corners += static_cast<int>(joined.face(f).size());
  }
  EXPECT_EQ(corners, 7) << "a quad and the half of another";
}

TEST(JoinTriangles, RealQuadMeshesComeBack) {
  for (const std::string name : {"pq_static_roof", "pq_gitter", "quad_pillow", "pq_octtorus"}) {
    const auto bytes = testing::shared_mesh_bytes(name + ".obj");
    if (!bytes) GTEST_SKIP() << "skipped: no shared meshes";
    const Mesh mesh = std::get<MeshFile>(read_obj(*bytes)).mesh;
    std::mt19937 random(11);
    Faces faces = faces_of(split(mesh, [](std::size_t f) { return f % 3 == 0; }));
    std::shuffle(faces.begin(), faces.end(), random);
    const Mesh joined = join_triangles(with_faces(mesh, faces));
    EXPECT_EQ(testing::error_text(check_mesh(joined)), "") << name;
    Faces known = corner_sets(mesh), found = corner_sets(joined), both;
    std::set_intersection(known.begin(), known.end(), found.begin(), found.end(),
                          std::back_inserter(both));
    const double share = static_cast<double>(both.size()) / static_cast<double>(known.size());
    RecordProperty(name, std::to_string(share));
    EXPECT_GE(share, 0.9) << name;
  }
}

}  // namespace
}  // namespace planish
