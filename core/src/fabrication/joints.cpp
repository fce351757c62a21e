// SPDX-License-Identifier: MIT
#include "planish/fabrication/joints.hpp"

#include <Eigen/Geometry>

#include "mesh/edge_table.hpp"
#include "numeric/trigonometry.hpp"
#include "planish/fabrication/panel_frame.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

PanelSide side_of(const Mesh& mesh, const EdgeUse& use) {
  return {use.face, use.corner - mesh.face_offsets[at(use.face)]};
}

Joint joint_of(const Mesh& mesh, const Positions& normals, std::span<const EdgeUse> uses) {
  const EdgeUse& first = uses[0];
  Joint joint;
  joint.from = mesh.face_vertices[at(first.corner)];
  joint.to = mesh.face_vertices[at(first.next_corner)];
  joint.first = side_of(mesh, first);
  const Eigen::Vector3d edge = mesh.positions.col(joint.to) - mesh.positions.col(joint.from);
  joint.length = edge.stableNorm();
  joint.dihedral = kPi;
  if (uses.size() < 2) return joint;
  joint.second = side_of(mesh, uses[1]);
  joint.same_way = uses[0].forward == uses[1].forward;
  const Eigen::Vector3d there = normals.col(joint.second.panel);
  joint.dihedral = dihedral(edge, normals.col(joint.first.panel),
                            joint.same_way ? Eigen::Vector3d(-there) : there);
  return joint;
}

}  // namespace

double dihedral(const Eigen::Vector3d& edge, const Eigen::Vector3d& first,
                const Eigen::Vector3d& second) {
  const Eigen::Vector3d e = edge.stableNormalized();
  const Eigen::Vector3d a = first - e * e.dot(first);
  const Eigen::Vector3d b = second - e * e.dot(second);
  return kPi - arctangent(a.cross(b).dot(e), a.dot(b));
}

JointTable joint_table(const Mesh& mesh) {
  Positions normals(3, mesh.face_count());
  for (int f = 0; f < mesh.face_count(); ++f) {
    normals.col(f) = panel_normal(mesh.positions, mesh.face(f));
  }
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  std::vector<std::span<const EdgeUse>> edge_of(mesh.face_vertices.size());  // of each side
  for (const auto edge : by_edge(uses)) {
    for (const EdgeUse& use : edge) edge_of[at(use.corner)] = edge;
  }
  JointTable table;
  table.of_side.assign(mesh.face_vertices.size(), -1);
  for (std::size_t side = 0; side < edge_of.size(); ++side) {
    if (table.of_side[side] >= 0) continue;
    for (const EdgeUse& use : edge_of[side]) {
      table.of_side[at(use.corner)] = static_cast<int>(table.joints.size());
    }
    table.joints.push_back(joint_of(mesh, normals, edge_of[side]));
  }
  return table;
}

}  // namespace planish
