// SPDX-License-Identifier: MIT
// Panels with points of their own, joined; panels turned to agree.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "planish/io/mesh_format.hpp"
#include "planish/mesh/area_vector.hpp"
#include "planish/mesh/mesh_check.hpp"
#include "planish/mesh/orientation.hpp"
#include "planish/mesh/point_joining.hpp"
#include "support/mesh_builders.hpp"
#include "support/small_files.hpp"

namespace planish {
namespace {

using testing::four_panels;
using testing::outcome;
using testing::points_apart;
using testing::same_bits;

/// The corners of `face` the other way round, from the same one.
void turn(Mesh& mesh, int face) {
  const auto f = static_cast<std::size_t>(face);
  const auto begin = mesh.face_vertices.begin();
  std::reverse(begin + mesh.face_offsets[f] + 1, begin + mesh.face_offsets[f + 1]);
}

TEST(PanelsJoined, AFileSaysHowAndIsJoined) {
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kOff, MeshFormat::kPly}) {
    const ReadResult read = read_mesh(write_mesh(points_apart(four_panels()), format), format);
    EXPECT_NE(outcome(read).find("7 vertices lie exactly where another one does (first: vertices "),
              std::string::npos);
    EXPECT_NE(outcome(read).find("convert --join-points"), std::string::npos);
    const ReadResult joined = join_points(std::get<MeshFile>(read).mesh);
    EXPECT_EQ(outcome(joined),
              "9 points, 4 faces | 7 vertices were joined with another one at the same place");
    EXPECT_EQ(summarize(std::get<MeshFile>(joined).mesh).components, 1);
  }
}

/// Bays that a program turned about an axis, each with points of its own.
TEST(PanelsJoined, PointsThatDifferByRoundingAreFoundAndJoined) {
  Mesh apart = points_apart(four_panels());
  for (Eigen::Index v = 0; v < 16; ++v) apart.positions(2, v) += 1e-9 * static_cast<double>(v);
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kOff, MeshFormat::kPly}) {
    const ReadResult read = read_mesh(write_mesh(apart, format), format);
    EXPECT_EQ(
        outcome(read),
        "16 points, 4 faces | 7 vertices lie within 1e-08 of another one (first: vertices 1 and "
        "4); they are not joined; convert --join-points joins them");
    const ReadResult joined = join_points(std::get<MeshFile>(read).mesh);
    EXPECT_EQ(outcome(joined).find("9 points, 4 faces | 7 vertices were joined"), 0u);
    EXPECT_EQ(summarize(std::get<MeshFile>(joined).mesh).components, 1);
  }
}

TEST(PanelsJoined, WithinADistance) {
  Mesh apart = points_apart(four_panels());
  for (Eigen::Index v = 0; v < 16; ++v) apart.positions(2, v) += 1e-4 * static_cast<double>(v);
  EXPECT_EQ(outcome(join_points(apart)).substr(0, 19), "16 points, 4 faces");
  EXPECT_EQ(
      outcome(join_points(apart, 0.01))
          .find("9 points, 4 faces | 7 vertices were joined with another one at the same place, up "
                "to 0.00"),
      0u);
  const std::string refusal =
      "points can be joined within less than half the shortest side, which is 1.51327 long";
  for (const double within : {-1.0, 0.8, 100.0}) {
    EXPECT_EQ(outcome(join_points(four_panels(), within)), refusal);
  }
}

TEST(PanelsJoined, WhereThatGivesNoMeshItSaysSo) {
  Mesh twice = points_apart(four_panels());
  const Mesh more = points_apart(
      testing::make_mesh({{0, 0, 1.5}, {2, 0, 1.8}, {2, 1.5, 2}, {0, 1.5, 1.7}}, {{0, 1, 2, 3}}));
  twice.positions.conservativeResize(3, 20);
  twice.positions.rightCols(4) = more.positions;
  for (int k = 16; k < 20; ++k) twice.face_vertices.push_back(k);
  twice.face_offsets.push_back(20);
  EXPECT_EQ(
      outcome(join_points(twice)),
      "once its points are joined, face 4 has the same corners as face 0; a panel can be given "
      "once");
}

TEST(PanelsTurned, NeighboursAgreeAndAnOpenMeshFacesUp) {
  for (const std::vector<int>& turned :
       {std::vector<int>{1}, {0}, {0, 3}, {0, 1, 2}, {0, 1, 2, 3}}) {
    Mesh mesh = four_panels();
    for (const int f : turned) turn(mesh, f);
    const Oriented result = oriented(mesh);
    EXPECT_TRUE(same_bits(result.mesh, four_panels()));
    EXPECT_EQ(result.turned, static_cast<int>(turned.size()));
  }
  EXPECT_EQ(oriented(four_panels()).turned, 0);
}

Mesh tetrahedron() {
  return testing::make_mesh({{9, 0, 0}, {10, 0, 0}, {9, 1, 0}, {9, 0, 1}},
                            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

TEST(PanelsTurned, TheOutsideOfABodyComesOut) {
  for (const std::vector<int>& turned : {std::vector<int>{0, 1, 2, 3}, {0}, {1, 2}, {}}) {
    Mesh mesh = tetrahedron();
    for (const int f : turned) turn(mesh, f);
    EXPECT_TRUE(same_bits(oriented(mesh).mesh, tetrahedron()));
  }
}

TEST(PanelsTurned, AWallKeepsMostOfItAndAMoebiusStripAll) {
  Mesh wall = four_panels();
  wall.positions.row(2).setZero();
  wall.positions.row(1).swap(wall.positions.row(2));  // faces along y
  Mesh one = wall;
  turn(one, 2);
  EXPECT_TRUE(same_bits(oriented(one).mesh, wall));
  const auto bytes = testing::shared_mesh_bytes("nasty/moebius_quads.obj");
  if (!bytes) GTEST_SKIP() << "no shared meshes";
  const Mesh strip = std::get<MeshFile>(read_mesh(*bytes, MeshFormat::kObj)).mesh;
  EXPECT_TRUE(same_bits(oriented(strip).mesh, strip));
}

}  // namespace
}  // namespace planish
