// SPDX-License-Identifier: MIT
/// Cuts one by one: what they make of small meshes, and what they refuse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "support/cut_checks.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::make_mesh;
using testing::parsed_cut;
using testing::quad_grid;
using CornerList = std::vector<int>;

std::vector<Cut> parsed_cuts(const std::vector<std::string>& texts) {
  std::vector<Cut> cuts;
  for (const std::string& text : texts) cuts.push_back(parsed_cut(text));
  return cuts;
}

/// The mesh after cuts, valid ones where none is a trim.
CutMesh after_cuts(const Mesh& mesh, const std::vector<std::string>& texts) {
  auto made = cut_mesh(mesh, parsed_cuts(texts));
  if (const auto* why = std::get_if<std::string>(&made)) {
    ADD_FAILURE() << *why;
    return {mesh, {}, {}, {}};
  }
  const bool trims = std::any_of(texts.begin(), texts.end(),
                                 [](const std::string& text) { return text.starts_with("trim"); });
  testing::CutFigures figures;
  if (!trims) {
    EXPECT_TRUE(testing::is_valid_cut(mesh, std::get<CutMesh>(made), 1e-12, figures)) << texts[0];
  }
  return std::get<CutMesh>(std::move(made));
}

/// Why a cut is refused; "" where it is made.
std::string why_not(const Mesh& mesh, const std::vector<std::string>& texts) {
  const auto made = cut_mesh(mesh, parsed_cuts(texts));
  const auto* why = std::get_if<std::string>(&made);
  return why != nullptr ? *why : "";
}

CornerList corners_of(const CutMesh& cut, int f) {
  const auto face = cut.mesh.face(f);
  return {face.begin(), face.end()};
}

Eigen::Vector3d place_of(const CutMesh& cut, int v) { return cut.mesh.positions.col(v); }

/// An L of six corners; 3 is the reflex one.
Mesh ell_panel() {
  return make_mesh({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
                   {{0, 1, 2, 3, 4, 5}});
}

/// Quads around a ring that comes back upside down: points 2k and 2k + 1 across it.
Mesh half_turn_ring(int count) {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> faces;
  for (int k = 0; k < count; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / count;
    const Eigen::Vector3d out(std::cos(turn), std::sin(turn), 0.0);
    const Eigen::Vector3d across =
        0.5 * (std::cos(turn / 2.0) * out + std::sin(turn / 2.0) * Eigen::Vector3d::UnitZ());
    points.insert(points.end(), {2.0 * out - across, 2.0 * out + across});
    const int next = 2 * ((k + 1) % count), flip = k + 1 == count ? 1 : 0;
    faces.push_back({2 * k, 2 * k + 1, next + 1 - flip, next + flip});
  }
  return make_mesh(points, faces);
}

TEST(CutMesh, SplitsAPanelWhoseFirstPartKeepsItsNumber) {
  const CutMesh made = after_cuts(quad_grid(3, 2), {"split=0:0,4"});
  EXPECT_EQ(corners_of(made, 0), (CornerList{0, 1, 4}));
  EXPECT_EQ(corners_of(made, 2), (CornerList{4, 3, 0}));
  EXPECT_EQ(made.parents, (CornerList{0, 1, 0}));
  EXPECT_EQ(made.records[0].panels, (CornerList{0, 2}));
  EXPECT_TRUE(made.added.empty());
}

TEST(CutMesh, GivesNeighboursStraightCorners) {
  const CutMesh made = after_cuts(quad_grid(3, 2), {"split=0:3,1-4@0.25"});
  EXPECT_EQ(place_of(made, 6), Eigen::Vector3d(1, 0.25, 0));
  EXPECT_EQ(corners_of(made, 1), (CornerList{1, 2, 5, 4, 6}));
  EXPECT_EQ(made.records[0].straight, (CornerList{1}));
  EXPECT_EQ(made.records[0].points, (CornerList{6}));
  ASSERT_EQ(made.added.size(), 1U);
  EXPECT_EQ(made.added[0].from, 1);
  EXPECT_EQ(made.added[0].to, 4);
  EXPECT_EQ(made.added[0].panel, -1);
}

/// A point on a line that parted a panel stands inside it, one on half a side on the side.
TEST(CutMesh, KnowsWhereAddedPointsStand) {
  const CutMesh made =
      after_cuts(quad_grid(2, 2), {"strip=0-1", "split=0:4-5@0.5,0", "split=1:4-3@0.5,1"});
  ASSERT_EQ(made.added.size(), 4U);
  EXPECT_EQ(made.added[2].panel, 0);
  EXPECT_EQ(made.added[2].from, -1);
  EXPECT_EQ(made.added[3].panel, -1);
  EXPECT_EQ((CornerList{made.added[3].from, made.added[3].to}), (CornerList{2, 3}));
}

TEST(CutMesh, LaysAStripFromBoundaryToBoundary) {
  const CutMesh made = after_cuts(quad_grid(4, 3), {"strip=1-2@0.25"});
  EXPECT_EQ(made.mesh.face_count(), 8);
  EXPECT_EQ(made.mesh.vertex_count(), 15);
  for (const AddedPoint& point : made.added) EXPECT_EQ(place_of(made, point.vertex).x(), 1.25);
  // Of panels 1 and 4 the part beside point 1 keeps the number.
  for (const int f : {1, 4}) EXPECT_LT(made.mesh.positions(0, corners_of(made, f)[0]), 1.5);
  EXPECT_TRUE(made.records[0].straight.empty());
}

TEST(CutMesh, EndsAStripWhereAPanelIsNoQuad) {
  const Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 2, 0}},
                              {{0, 1, 2, 3}, {3, 2, 4}});
  const CutMesh made = after_cuts(mesh, {"strip=1-0"});
  EXPECT_EQ(corners_of(made, 1).size(), 4U);
  EXPECT_EQ(made.records[0].straight, (CornerList{1}));
  EXPECT_EQ(why_not(mesh, {"strip=2-4"}), "strip=2-4: no quad has the side from 2 to 4");
}

/// Three quads around a prism.
TEST(CutMesh, ClosesAStripThatComesBack) {
  const Mesh prism = make_mesh({{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {0, 0, 1}, {2, 0, 1}, {1, 2, 1}},
                               {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
  const CutMesh made = after_cuts(prism, {"strip=0-3@0.25"});
  EXPECT_EQ(made.mesh.face_count(), 6);
  EXPECT_EQ(made.mesh.vertex_count(), 9);
  for (const AddedPoint& point : made.added) EXPECT_EQ(place_of(made, point.vertex).z(), 0.25);
  EXPECT_EQ(testing::euler_characteristic(made.mesh), 0);
}

TEST(CutMesh, CutsACornerOff) {
  const CutMesh whole = after_cuts(quad_grid(2, 2), {"corner=0:1"});
  EXPECT_EQ(corners_of(whole, 0), (CornerList{3, 2, 0}));
  EXPECT_EQ(corners_of(whole, 1), (CornerList{0, 1, 3}));
  const CutMesh half = after_cuts(quad_grid(2, 2), {"corner=0:1@0.5"});
  EXPECT_EQ(corners_of(half, 0).size(), 5U);
  EXPECT_EQ(corners_of(half, 1).size(), 3U);
  EXPECT_EQ(place_of(half, 4), Eigen::Vector3d(1, 0.5, 0));
}

TEST(CutMesh, RefinesPanelsIntoQuads) {
  const CutMesh made = after_cuts(quad_grid(3, 2), {"refine=0,1"});
  EXPECT_EQ(made.mesh.face_count(), 8);
  EXPECT_EQ(made.mesh.vertex_count(), 15);  // the common side has one middle
  for (int f = 0; f < 8; ++f) EXPECT_EQ(corners_of(made, f).size(), 4U);
  // One after the other is the same: a straight corner is the middle of its side.
  EXPECT_EQ(after_cuts(quad_grid(3, 2), {"refine=0", "refine=1"}).mesh.face_vertices,
            made.mesh.face_vertices);
}

/// A panel with a reflex corner that its middle sees.
TEST(CutMesh, RefinesPanelsThatTheirMiddleSees) {
  const Mesh mesh =
      make_mesh({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1.6, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4}});
  EXPECT_EQ(after_cuts(mesh, {"refine=0"}).mesh.face_count(), 5);
}

TEST(CutMesh, RefinesWithACollarWithoutStraightCorners) {
  const Mesh mesh = quad_grid(4, 4);
  const CutMesh plain = after_cuts(mesh, {"refine=4"});
  EXPECT_EQ(plain.records[0].straight, (CornerList{1, 3, 5, 7}));
  EXPECT_EQ(plain.mesh.face_count(), 12);
  const CutMesh made = after_cuts(mesh, {"refine=4:collar"});
  EXPECT_TRUE(made.records[0].straight.empty());
  EXPECT_EQ(made.mesh.face_count(), 16);
  // A panel between refined ones is split from middle to middle.
  EXPECT_EQ(after_cuts(quad_grid(4, 2), {"refine=0,2:collar"}).mesh.face_count(), 10);
}

TEST(CutMesh, TrimsByAPlane) {
  const CutMesh made = after_cuts(quad_grid(4, 2), {"trim=2,0,0,3"});
  EXPECT_EQ(made.mesh.face_count(), 2);
  EXPECT_EQ(made.parents, (CornerList{0, 1}));
  for (const int v : corners_of(made, 1)) EXPECT_LE(made.mesh.positions(0, v), 1.5);
  const CutMesh other = after_cuts(quad_grid(4, 2), {"trim=-1,0,0,-1.5"});
  EXPECT_EQ(other.parents, (CornerList{1, 2}));
  EXPECT_EQ(corners_of(other, 1), (CornerList{2, 3, 7, 6}));
  EXPECT_EQ(other.mesh.vertex_count(), 10);  // points keep their numbers
  // Along points that are there no point is added.
  EXPECT_EQ(after_cuts(quad_grid(4, 2), {"trim=1,0,0,2"}).mesh.vertex_count(), 8);
}

TEST(CutMesh, CountsPanelsAfterATrimAnew) {
  const CutMesh made = after_cuts(quad_grid(4, 2), {"trim=-1,0,0,-1", "split=1:2,7"});
  EXPECT_EQ(made.parents, (CornerList{1, 2, 2}));
  const CutMesh gone = after_cuts(quad_grid(4, 2), {"split=0:0,5", "trim=-1,0,0,-1"});
  EXPECT_EQ(gone.parents, (CornerList{1, 2}));
  EXPECT_TRUE(gone.records[0].panels.empty());
}

TEST(CutMesh, KeepsGroups) {
  Mesh mesh = quad_grid(4, 2);
  mesh.groups = {{"glass", 1, false}, {"solid", 2, false}};
  const auto groups = after_cuts(mesh, {"split=1:1,6", "split=0:0,5", "split=2:2,7"}).mesh.groups;
  std::vector<std::pair<std::string, int>> named;
  for (const FaceGroup& group : groups) named.emplace_back(group.name, group.first_face);
  EXPECT_EQ(named, (std::vector<std::pair<std::string, int>>{
                       {"glass", 1}, {"solid", 2}, {"glass", 3}, {"", 4}, {"solid", 5}}));
}

TEST(CutMesh, RefusesWhatIsNotThere) {
  const Mesh mesh = quad_grid(3, 2);
  EXPECT_EQ(why_not(mesh, {"split=2:0,4"}), "split=2:0,4: there is no panel 2: panels are 0 to 1");
  EXPECT_EQ(why_not(mesh, {"split=0:0,2"}), "split=0:0,2: panel 0 has no corner 2");
  EXPECT_EQ(why_not(mesh, {"split=0:0,1-3@0.5"}),
            "split=0:0,1-3@0.5: panel 0 has no side from 1 to 3");
  EXPECT_EQ(why_not(mesh, {"split=0:0,1-99@0.5"}),
            "split=0:0,1-99@0.5: panel 0 has no side from 1 to 99");
  EXPECT_EQ(why_not(mesh, {"corner=1:0"}), "corner=1:0: panel 1 has no corner 0");
  EXPECT_EQ(why_not(mesh, {"strip=0-99"}), "strip=0-99: no panel has the side from 0 to 99");
  EXPECT_EQ(why_not(mesh, {"strip=0-4"}), "strip=0-4: no panel has the side from 0 to 4");
  EXPECT_EQ(why_not(mesh, {"refine=0,7"}), "refine=0,7: there is no panel 7: panels are 0 to 1");
}

TEST(CutMesh, RefusesLinesThatPartNothing) {
  const Mesh mesh = quad_grid(3, 2);
  EXPECT_EQ(why_not(mesh, {"split=0:0,1"}),
            "split=0:0,1: points 0 and 1 are neighbours on the outline of panel 0");
  EXPECT_EQ(why_not(mesh, {"split=0:0-1@0.25,1-0@0.25"}),
            "split=0:0-1@0.25,1-0@0.25: A and B are on one side of panel 0");
  EXPECT_EQ(why_not(mesh, {"split=0:0,0-1@0.5"}),
            "split=0:0,0-1@0.5: points 0 and 6 are neighbours on the outline of panel 0");
  // Past a straight corner.
  EXPECT_EQ(why_not(mesh, {"split=0:3,1-4@0.5", "split=1:1,4"}),
            "split=1:1,4: the line from point 1 to 4 runs along the outline of panel 1");
  EXPECT_EQ(why_not(testing::triangle_grid(2, 2), {"corner=0:0"}),
            "corner=0:0: panel 0 is a triangle, of which a share T below 1 can be cut off");
}

TEST(CutMesh, RefusesLinesThatLeaveAPanel) {
  EXPECT_EQ(why_not(ell_panel(), {"split=0:2,4"}),
            "split=0:2,4: the line from point 2 to 4 leaves panel 0, which is not convex");
  EXPECT_EQ(why_not(ell_panel(), {"corner=0:3"}),
            "corner=0:3: the line from point 4 to 2 leaves panel 0, which is not convex");
  EXPECT_EQ(why_not(ell_panel(), {"split=0:1,5"}),
            "split=0:1,5: the line from point 1 to 5 leaves panel 0, which is not convex");
  EXPECT_EQ(corners_of(after_cuts(ell_panel(), {"split=0:3,0"}), 0), (CornerList{3, 4, 5, 0}));
  EXPECT_EQ(why_not(ell_panel(), {"refine=0"}),
            "refine=0: panel 0 is not convex enough to be refined about its middle");
  EXPECT_EQ(why_not(ell_panel(), {"trim=1,1,0,2.5"}),
            "trim=1,1,0,2.5: the plane crosses panel 0, which is not convex, more than once");
}

/// The two panels of a sheet that is folded over one of its diagonals.
TEST(CutMesh, RefusesASideOfOtherPanels) {
  const Mesh mesh =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}}, {{0, 1, 2, 3}, {0, 2, 4}});
  EXPECT_EQ(why_not(mesh, {"split=0:0,2"}),
            "split=0:0,2: the line from point 0 to 2 is a side of other panels already");
}

TEST(CutMesh, RefusesTrimsOfAllAndNothing) {
  const Mesh mesh = quad_grid(3, 2);
  EXPECT_EQ(why_not(mesh, {"trim=1,0,0,2"}),
            "trim=1,0,0,2: nothing of the mesh lies beyond the plane");
  EXPECT_EQ(why_not(mesh, {"trim=1,0,0,-1"}),
            "trim=1,0,0,-1: all of the mesh lies beyond the plane");
}

/// A ring of quads with a half turn in it: the line would come back at the other share.
TEST(CutMesh, RefusesStripsThatTurnOver) {
  const Mesh moebius = half_turn_ring(5);
  EXPECT_EQ(
      why_not(moebius, {"strip=0-1@0.25"}),
      "strip=0-1@0.25: the strip comes back to its side turned over, where only the share 0.5 "
      "fits");
  EXPECT_EQ(after_cuts(moebius, {"strip=0-1"}).mesh.face_count(), 10);
}

/// A quad whose right neighbour is joined to its upper one by a fourth quad: a line through it
/// comes back from above.
TEST(CutMesh, LaysAStripAcrossItself) {
  const Mesh mesh = make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}},
      {{0, 1, 2, 3}, {1, 4, 5, 2}, {3, 2, 7, 6}, {4, 6, 7, 5}});
  const CutMesh made = after_cuts(mesh, {"strip=0-3@0.25"});
  EXPECT_EQ(testing::euler_characteristic(made.mesh), testing::euler_characteristic(mesh));
  // Twice through the first quad makes four of it, about the point where the lines cross.
  EXPECT_EQ(std::count(made.parents.begin(), made.parents.end(), 0), 4);
  const auto middle = std::find_if(made.added.begin(), made.added.end(),
                                   [](const AddedPoint& point) { return point.panel == 0; });
  ASSERT_NE(middle, made.added.end());
  EXPECT_NEAR(place_of(made, middle->vertex).y(), 0.25, 1e-15);
}

TEST(CutMesh, CutsNothingWithoutCuts) {
  const Mesh mesh = quad_grid(3, 2);
  const auto made = cut_mesh(mesh, {});
  EXPECT_TRUE(testing::same_bits(std::get<CutMesh>(made).mesh, mesh));
}

}  // namespace
}  // namespace planish
