// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <set>
#include <variant>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/fabrication/remake.hpp"
#include "planish/mesh/adjacency.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// What a node is made by, worked out from the panels' corners alone.
struct NodeDirections {
  std::vector<Eigen::Vector3d> planes;  ///< of the panels around it
  std::vector<Eigen::Vector3d> arms;
  Eigen::Vector3d axis;
};

/// Sum of the triangles of a fan, relative to the first corner.
Eigen::Vector3d fan_area(const Mesh& mesh, int f) {
  const auto face = mesh.face(f);
  const Eigen::Vector3d a = mesh.positions.col(face[0]);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 2; k < face.size(); ++k) {
    sum += (mesh.positions.col(face[k - 1]) - a).cross(mesh.positions.col(face[k]) - a);
  }
  return sum;
}

NodeDirections directions(const Mesh& mesh, int vertex) {
  NodeDirections node;
  std::set<int> ends;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k) {
      if (face[k] != vertex) continue;
      ends.insert({face[(k + 1) % n], face[(k + n - 1) % n]});
      mean += fan_area(mesh, f);
      node.planes.push_back(fan_area(mesh, f).normalized());
    }
  }
  for (const int end : ends) {
    node.arms.push_back((mesh.positions.col(end) - mesh.positions.col(vertex)).normalized());
  }
  node.axis = mean.normalized();
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(node.planes.size()), 3);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    rows.row(k) = node.planes[static_cast<std::size_t>(k)].transpose();
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(rows.rows());
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> planes(rows);
  if (rows.rows() < 3 || planes.rank() < 3) return node;
  const Eigen::Vector3d common = planes.solve(ones);
  const double miss = (rows * common - ones).norm() / std::sqrt(static_cast<double>(rows.rows()));
  if (miss <= 1e-9) node.axis = common.normalized();
  return node;
}

bool turned(const Eigen::Vector3d& before, const Eigen::Vector3d& after) {
  return std::atan2(before.cross(after).norm(), before.dot(after)) > kSameAngle;
}

bool turned(const std::vector<Eigen::Vector3d>& before, const std::vector<Eigen::Vector3d>& after) {
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (turned(before[k], after[k])) return true;
  }
  return false;
}

NodeChange expected_change(const Mesh& base, const Mesh& mesh, int vertex) {
  if (base.positions.col(vertex) != mesh.positions.col(vertex)) return NodeChange::kMoved;
  const NodeDirections before = directions(base, vertex);
  const NodeDirections after = directions(mesh, vertex);
  const bool other = turned(before.arms, after.arms) || turned(before.planes, after.planes) ||
                     turned(before.axis, after.axis);
  return other ? NodeChange::kArms : NodeChange::kUnchanged;
}

struct Edited {
  Mesh base, mesh;
  std::vector<int> moved;
};

Edited edited(const char* name) {
  const Mesh base = testing::sample(name, 14);
  const auto targets = testing::pull(base, testing::middle_vertex(base), {0.0, 0.1, 0.4});
  const auto result = solve_handle_edit(base, targets);
  Edited edit{base, base, {}};
  edit.mesh.positions = apply(base, result);
  for (const int v : result.moved) {
    if (base.positions.col(v) != edit.mesh.positions.col(v)) edit.moved.push_back(v);
  }
  return edit;
}

constexpr std::array kSamples = {"vault", "dome", "freeform", "hex", "trihex"};

TEST(RemakeOfNodes, IsThoseThatMovedOrHaveAnotherAngle) {
  int unchanged = 0;
  for (const char* name : kSamples) {
    const auto [base, mesh, moved] = edited(name);
    const Remake remake = find_remake(base, mesh);
    for (int v = 0; v < base.vertex_count(); ++v) {
      EXPECT_EQ(remake.nodes[static_cast<std::size_t>(v)], expected_change(base, mesh, v))
          << name << " node " << v;
    }
    EXPECT_EQ(remake.count(NodeChange::kMoved), static_cast<int>(moved.size())) << name;
    EXPECT_GT(remake.count(NodeChange::kArms), 3) << name;
    unchanged += remake.count(NodeChange::kUnchanged);
  }
  EXPECT_GT(unchanged, 50);
}

TEST(RemakeOfNodes, NearTheMovedPointsIsTheSameAsEverywhere) {
  for (const char* name : kSamples) {
    const auto [base, mesh, moved] = edited(name);
    EXPECT_EQ(nodes_to_remake(base, build_adjacency(base), mesh.positions, moved),
              find_remake(base, mesh).nodes)
        << name;
  }
}

/// Four roof panels around a node whose planes have no common axis; one of them grows in its plane.
TEST(RemakeOfNodes, HasThoseWhoseAxisAloneTurned) {
  const Mesh base = testing::make_mesh({{0, 0, 0},
                                        {1, 0, -0.1},
                                        {1, 1, -0.3},
                                        {0, 1, -0.2},
                                        {-1, 1, -0.5},
                                        {-1, 0, -0.3},
                                        {-1, -1, -0.7},
                                        {0, -1, -0.4},
                                        {1, -1, -0.5}},
                                       {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 7}, {0, 7, 8, 1}});
  Mesh mesh = base;
  mesh.positions.col(2) *= 1.5;
  const Remake remake = find_remake(base, mesh);
  EXPECT_EQ(remake.count(PanelChange::kOutline), 1);
  EXPECT_EQ(remake.count(PanelChange::kBevel), 0);
  EXPECT_EQ(remake.nodes[0], NodeChange::kArms);
  EXPECT_EQ(remake.nodes[0], expected_change(base, mesh, 0));
}

/// Around a point where three planes meet the axis is theirs, however large the panels are.
TEST(RemakeOfNodes, KeepsThoseAtTheEndsOfADividedSide) {
  const Mesh base = testing::sample("hex", 8);
  int ends = 0;
  for (int f = 0; f < base.face_count(); ++f) {
    const auto face = base.face(f);
    const SplitCut cut{f, {face[0], face[1], 0.4}, {face[3], face[4], 0.5}};
    const auto made = std::get<CutMesh>(cut_mesh(base, {cut}));
    const Remake remake = find_remake(base, made.mesh);
    for (const AddedPoint& point : made.added) {
      EXPECT_EQ(remake.nodes[static_cast<std::size_t>(point.vertex)], NodeChange::kNew);
      for (const int end : {point.from, point.to}) {
        const auto three = directions(base, end).planes.size() == 3;
        const NodeChange change = remake.nodes[static_cast<std::size_t>(end)];
        if (three) {
          EXPECT_EQ(change, NodeChange::kUnchanged) << "panel " << f << " node " << end;
        }
        EXPECT_NE(change, NodeChange::kNew) << "panel " << f << " node " << end;
        ends += three ? 1 : 0;
      }
    }
    EXPECT_EQ(remake.count(NodeChange::kNew), 2) << "panel " << f;
  }
  EXPECT_GT(ends, 50);
}

/// A line into a corner is one more arm there.
TEST(RemakeOfNodes, CallsNewWhereALineEnds) {
  const Mesh base = testing::quad_grid(4, 4);
  const auto made = std::get<CutMesh>(cut_mesh(base, {SplitCut{4, {5}, {10}}}));
  const Remake remake = find_remake(base, made.mesh);
  EXPECT_EQ(remake.count(NodeChange::kNew), 2);
  EXPECT_EQ(remake.nodes[5], NodeChange::kNew);
  EXPECT_EQ(remake.nodes[10], NodeChange::kNew);
  EXPECT_EQ(remake.nodes[6], NodeChange::kUnchanged) << "a part's corner in the same plane";
}

TEST(RemakeOfNodes, CallsNewWhatTheBaseHasNot) {
  const Mesh base =
      testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  const Mesh more =
      testing::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                         {{0, 1, 2, 3}, {1, 4, 5, 2}});
  const Remake remake = find_remake(base, more);
  EXPECT_EQ(remake.count(NodeChange::kNew), 4);  // two have another neighbour now
  EXPECT_EQ(remake.nodes[0], NodeChange::kUnchanged);
}

}  // namespace
}  // namespace planish
