// SPDX-License-Identifier: MIT
#include "planish/fabrication/panel_tables.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "fabrication/neighbours.hpp"
#include "fabrication/node_axis.hpp"
#include "fabrication/outline_measures.hpp"
#include "fabrication/table_writer.hpp"
#include "numeric/trigonometry.hpp"
#include "planish/constraints/planar_polygon.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kDegrees = 180.0 / kPi;

std::array<double, 3> triple(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

std::string change_of_panel(const CuttingPlan& plan, int face) {
  return plan.remake ? std::string(change_name(plan.remake->panels[at(face)])) : "";
}

std::string change_of_node(const CuttingPlan& plan, int vertex) {
  return plan.remake ? std::string(change_name(plan.remake->nodes[at(vertex)])) : "";
}

std::string name_of(const CuttingPlan& plan, const Joint& joint) {
  return edge_name(static_cast<int>(&joint - plan.joints.joints.data()));
}

/// Nodes, edges and neighbours of a panel, corner by corner.
void add_surroundings(TableWriter& table, const CuttingPlan& plan, int face) {
  std::vector<std::string> nodes;
  std::vector<std::string> edges;
  const auto corners = plan.mesh.face(face);
  for (int k = 0; k < static_cast<int>(corners.size()); ++k) {
    nodes.push_back(node_name(plan.node_of_vertex[at(corners[at(k)])]));
    edges.push_back(name_of(plan, joint_at(plan, face, k)));
  }
  table.add("nodes", nodes).add("edges", edges).add("neighbours", neighbour_names(plan, face));
}

/// The outline with its frame, and what is measured on it.
void add_shape(TableWriter& table, const CuttingPlan& plan, int face) {
  const FlatPanel& panel = plan.panels[at(face)];
  const Outline& outline = panel.outline;
  table.add("outline", std::span(outline.data(), static_cast<std::size_t>(outline.size())))
      .add("off_plane", panel.off_plane)
      .add("origin", triple(panel.frame.origin))
      .add("x_axis", triple(panel.frame.x))
      .add("normal", triple(panel.frame.normal));
  add_measures(table, outline);
  if (plan.options.thickness > 0.0) table.add("volume", area_of(outline) * plan.options.thickness);
}

void add_setting_out(TableWriter& table, const CuttingPlan& plan, int face) {
  std::vector<std::string> nodes;
  for (const int corner : setting_out_corners(plan.panels[at(face)].outline)) {
    nodes.push_back(node_name(plan.node_of_vertex[at(plan.mesh.face(face)[at(corner)])]));
  }
  table.add("setting_out", nodes);
}

/// Which type a panel is of, in a package that has types.
void add_type(TableWriter& table, const CuttingPlan& plan, int face) {
  if (!plan.types) return;
  const FamilyMember& member = plan.types->panels.panels[at(face)];
  table.add("type", type_name(member.family))
      .add("turned_over", member.mirrored ? "yes" : "no")
      .add("fit", member.distance);
}

/// How a fold looks from outside.
const char* fold_name(const Joint& joint) {
  if (joint.second.panel < 0) return "boundary";
  if (std::abs(joint.dihedral - kPi) <= kSameAngle) return "flat";
  return joint.dihedral < kPi ? "convex" : "concave";
}

/// The joints at each vertex, ascending.
std::vector<std::vector<int>> joints_by_vertex(const CuttingPlan& plan) {
  std::vector<std::vector<int>> joints(at(plan.mesh.vertex_count()));
  for (std::size_t k = 0; k < plan.joints.joints.size(); ++k) {
    joints[at(plan.joints.joints[k].from)].push_back(static_cast<int>(k));
    joints[at(plan.joints.joints[k].to)].push_back(static_cast<int>(k));
  }
  return joints;
}

/// The arms of a node: azimuth about the axis from the first arm on, elevation above the plane
/// across it.
void add_arms(TableWriter& table, const CuttingPlan& plan, int vertex, const Eigen::Vector3d& axis,
              const std::vector<int>& joints) {
  std::vector<std::string> arms;
  std::vector<double> azimuths;
  std::vector<double> elevations;
  Eigen::Vector3d zero = axis.unitOrthogonal();
  for (const int number : joints) {
    const Joint& joint = plan.joints.joints[at(number)];
    const int end = joint.from == vertex ? joint.to : joint.from;
    const Eigen::Vector3d arm =
        (plan.mesh.positions.col(end) - plan.mesh.positions.col(vertex)).stableNormalized();
    const Eigen::Vector3d flat = arm - axis * axis.dot(arm);
    if (arms.empty() && flat.norm() > 1e-9) zero = flat.normalized();
    const double azimuth = arctangent(axis.cross(zero).dot(flat), zero.dot(flat)) * kDegrees;
    arms.push_back(edge_name(number));
    azimuths.push_back(arms.size() == 1 ? 0.0 : azimuth < 0.0 ? azimuth + 360.0 : azimuth);
    elevations.push_back(arctangent(axis.dot(arm), flat.norm()) * kDegrees);
  }
  table.add("arms", arms).add("azimuths", azimuths).add("elevations", elevations);
}

}  // namespace

TableText panel_table(const CuttingPlan& plan) {
  const PanelNames& names = plan.options.names;
  TableWriter table;
  for (int f = 0; f < plan.mesh.face_count(); ++f) {
    table.row().add("panel", names.of(f));
    if (names.have_parents()) table.add("parent", names.parent_of(f));
    table.add("face", f).add("change", change_of_panel(plan, f));
    table.add("drawn", plan.drawn[at(f)] != 0 ? "yes" : "no");
    table.add("corners", static_cast<int>(plan.mesh.face(f).size()));
    add_surroundings(table, plan, f);
    add_shape(table, plan, f);
    table.add("flatness_mm_per_m", face_planarity(plan.mesh.positions, plan.mesh.face(f)).mm_per_m);
    add_setting_out(table, plan, f);
    add_type(table, plan, f);
  }
  return table.take();
}

TableText edge_table(const CuttingPlan& plan) {
  TableWriter table;
  for (const Joint& joint : plan.joints.joints) {
    table.row()
        .add("edge", name_of(plan, joint))
        .add("from", node_name(plan.node_of_vertex[at(joint.from)]))
        .add("to", node_name(plan.node_of_vertex[at(joint.to)]))
        .add("panel", plan.options.names.of(joint.first.panel))
        .add("side", joint.first.side)
        .add("neighbour", panel_or_nobody(plan, joint.second.panel))
        .add("neighbour_side", joint.second.side)
        .add("length", joint.length)
        .add("dihedral", joint.dihedral * kDegrees)
        .add("mitre", 90.0 - 0.5 * joint.dihedral * kDegrees)
        .add("fold", fold_name(joint));
    if (plan.types) {
      const auto number = &joint - plan.joints.joints.data();
      table.add("type", bar_type_name(plan.types->bars.of_joint[at(number)]));
    }
  }
  return table.take();
}

TableText node_table(const CuttingPlan& plan) {
  const Adjacency adjacency = build_adjacency(plan.mesh);
  const std::vector<std::vector<int>> joints = joints_by_vertex(plan);
  TableWriter table;
  for (std::size_t node = 0; node < plan.vertex_of_node.size(); ++node) {
    const int vertex = plan.vertex_of_node[node];
    const Eigen::Vector3d axis = node_axis(plan.mesh, plan.mesh.positions, adjacency, vertex);
    table.row()
        .add("node", node_name(static_cast<int>(node)))
        .add("vertex", vertex)
        .add("change", change_of_node(plan, vertex))
        .add("position", triple(plan.mesh.positions.col(vertex)))
        .add("valence", static_cast<int>(joints[at(vertex)].size()))
        .add("axis", triple(axis));
    add_arms(table, plan, vertex, axis, joints[at(vertex)]);
    if (plan.types) table.add("type", node_type_name(plan.types->nodes.of_vertex[at(vertex)]));
  }
  return table.take();
}

}  // namespace planish
