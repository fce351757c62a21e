// SPDX-License-Identifier: MIT
#include "planish/fabrication/remake.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <utility>
#include <variant>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/adjacency.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

Mesh with(Mesh mesh, const Positions& positions) {
  mesh.positions = positions;
  return mesh;
}

/// Three unit squares in a row; the points of column i are i and i + 4.
Mesh strip() { return testing::quad_grid(4, 2); }

/// Angle between the normals of two panels, from the cross product of diagonals.
double fold(const Mesh& mesh, int f, int g) {
  const auto normal = [&](int k) {
    const auto q = mesh.face(k);
    const Eigen::Vector3d a = mesh.positions.col(q[2]) - mesh.positions.col(q[0]);
    const Eigen::Vector3d b = mesh.positions.col(q[3]) - mesh.positions.col(q[1]);
    return a.cross(b).normalized().eval();
  };
  return std::atan2(normal(f).cross(normal(g)).norm(), normal(f).dot(normal(g)));
}

/// Pairs of panels with a common edge.
std::vector<std::pair<int, int>> neighbours(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> first;
  std::vector<std::pair<int, int>> pairs;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k];
      const int b = face[(k + 1) % face.size()];
      const auto [seen, is_new] = first.try_emplace({std::min(a, b), std::max(a, b)}, f);
      if (!is_new) pairs.emplace_back(seen->second, f);
    }
  }
  return pairs;
}

TEST(Remake, OfTheSameMeshIsNothing) {
  const Mesh mesh = testing::sample("dome", 12);
  const Remake remake = find_remake(mesh, mesh);
  EXPECT_EQ(remake.count(PanelChange::kUnchanged), mesh.face_count());
  for (const NodeChange node : remake.nodes) EXPECT_EQ(node, NodeChange::kUnchanged);
}

TEST(Remake, OfAnEditIsThePanelsWithAMovedCornerAndThoseWhoseAngleChanged) {
  for (const char* name : {"vault", "dome"}) {
    const Mesh base = testing::sample(name, 16);
    const auto result = solve_handle_edit(base, testing::pull(base, 8 * 16 + 8, {0.1, 0.2, 0.7}));
    const Mesh mesh = with(base, apply(base, result));
    const Remake remake = find_remake(base, mesh);
    std::vector<PanelChange> expected(static_cast<std::size_t>(base.face_count()),
                                      PanelChange::kUnchanged);
    for (const auto& [f, g] : neighbours(base)) {
      if (std::abs(fold(base, f, g) - fold(mesh, f, g)) > kSameAngle) {
        expected[static_cast<std::size_t>(f)] = expected[static_cast<std::size_t>(g)] =
            PanelChange::kBevel;
      }
    }
    for (int f = 0; f < base.face_count(); ++f) {
      for (const int v : base.face(f)) {
        if (base.positions.col(v) != mesh.positions.col(v)) {
          expected[static_cast<std::size_t>(f)] = PanelChange::kOutline;
        }
      }
    }
    EXPECT_EQ(remake.panels, expected) << name;
    EXPECT_GT(remake.count(PanelChange::kOutline), 3);
    EXPECT_GT(remake.count(PanelChange::kBevel), 3);
    EXPECT_GT(remake.count(PanelChange::kUnchanged), 50);
    int moved = 0;
    for (const NodeChange node : remake.nodes) moved += node == NodeChange::kMoved ? 1 : 0;
    EXPECT_EQ(moved, result.report.moved_vertices);
  }
}

TEST(Remake, NearTheMovedPointsIsTheSameAsEverywhere) {
  for (const char* name : {"vault", "dome", "freeform", "hex", "trihex"}) {
    const Mesh base = testing::sample(name, 14);
    const int middle = testing::middle_vertex(base);
    const auto result = solve_handle_edit(base, testing::pull(base, middle, {0.0, 0.1, 0.4}));
    const Mesh mesh = with(base, apply(base, result));
    std::vector<int> moved;  // those whose bits differ
    for (const int v : result.moved) {
      if (base.positions.col(v) != mesh.positions.col(v)) moved.push_back(v);
    }
    EXPECT_EQ(panels_to_remake(base, build_adjacency(base), mesh.positions, moved),
              find_remake(base, mesh).panels)
        << name;
  }
}

TEST(Remake, ANeighbourThatTurnsChangesTheBevelAlone) {
  const Mesh base = strip();
  Mesh mesh = base;
  mesh.positions(2, 3) = mesh.positions(2, 7) = 0.25;
  const Remake remake = find_remake(base, mesh);
  EXPECT_EQ(remake.panels,
            (std::vector{PanelChange::kUnchanged, PanelChange::kBevel, PanelChange::kOutline}));
  EXPECT_EQ(remake.nodes[0], NodeChange::kUnchanged);
  EXPECT_EQ(remake.nodes[1], NodeChange::kUnchanged);
  EXPECT_EQ(remake.nodes[2], NodeChange::kArms);
  EXPECT_EQ(remake.nodes[3], NodeChange::kMoved);
}

TEST(Remake, ANeighbourThatGrowsInItsPlaneChangesNoBevel) {
  const Mesh base = strip();
  Mesh mesh = base;
  mesh.positions(0, 3) = mesh.positions(0, 7) = 3.5;
  const Remake remake = find_remake(base, mesh);
  EXPECT_EQ(remake.panels,
            (std::vector{PanelChange::kUnchanged, PanelChange::kUnchanged, PanelChange::kOutline}));
  EXPECT_EQ(remake.nodes[2], NodeChange::kUnchanged);  // its arm is longer, and points where it did
}

TEST(Remake, TheLeastMoveOfACornerIsAnOutline) {
  const Mesh base = testing::quad_grid(4, 2);
  Mesh mesh = base;
  mesh.positions(0, 3) = std::nextafter(3.0, 4.0);
  EXPECT_EQ(find_remake(base, mesh).panels[2], PanelChange::kOutline);
}

TEST(Remake, APanelThatTheBaseHasNotIsNew) {
  const Mesh base =
      testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                         {{0, 1, 2, 3}, {1, 4, 5, 2}});
  const Mesh cut =
      testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                         {{0, 1, 2, 3}, {1, 4, 5}, {1, 5, 2}});
  EXPECT_EQ(find_remake(base, cut).panels,
            (std::vector{PanelChange::kUnchanged, PanelChange::kNew, PanelChange::kNew}));
  const Mesh alone =
      testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  EXPECT_EQ(find_remake(base, alone).panels,
            std::vector{PanelChange::kBevel});  // a side became free
}

/// Its neighbours meet it at one more node each, and are left as they are.
TEST(Remake, OfARefinedPanelIsItsPartsAlone) {
  const Mesh base = testing::sample("dome", 12);
  const int panel = base.face_count() / 2;
  const auto made = cut_mesh(base, {RefineCut{{panel}, false}});
  const auto& cut = std::get<CutMesh>(made);
  const Remake remake = find_remake(base, cut.mesh);
  EXPECT_EQ(remake.panels[static_cast<std::size_t>(panel)], PanelChange::kOutline);
  EXPECT_EQ(remake.count(PanelChange::kOutline), 1);
  EXPECT_EQ(remake.count(PanelChange::kNew), 3);
  EXPECT_EQ(remake.count(PanelChange::kBevel), 0);
  ASSERT_EQ(cut.records[0].straight.size(), 4U);
  for (const int f : cut.records[0].straight) {
    EXPECT_EQ(remake.panels[static_cast<std::size_t>(f)], PanelChange::kUnchanged);
  }
  for (int v = base.vertex_count(); v < cut.mesh.vertex_count(); ++v) {
    EXPECT_EQ(remake.nodes[static_cast<std::size_t>(v)], NodeChange::kNew);
  }
  // A corner on the side that is not straight is another outline.
  Mesh bent = cut.mesh;
  bent.positions.col(base.vertex_count()) += Eigen::Vector3d(0.01, 0.01, 0.0);
  EXPECT_EQ(find_remake(base, bent).count(PanelChange::kNew), 4);
}

}  // namespace
}  // namespace planish
