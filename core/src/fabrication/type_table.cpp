// SPDX-License-Identifier: MIT
#include "planish/fabrication/type_table.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "fabrication/outline_measures.hpp"
#include "fabrication/table_writer.hpp"
#include "planish/numeric/index.hpp"

namespace planish {

TableText type_table(const CuttingPlan& plan) {
  const PanelTypes& types = plan.types->panels;
  TableWriter table;
  for (int f = 0; f < plan.mesh.face_count(); ++f) {
    const FamilyMember& member = types.panels[at(f)];
    const Eigen::Matrix2d& turn = member.rotation;
    const std::array<double, 6> placement = {turn(0, 0), turn(1, 0),       turn(0, 1),
                                             turn(1, 1), member.shift.x(), member.shift.y()};
    table.row()
        .add("panel", plan.options.names.of(f))
        .add("face", f)
        .add("type", type_name(member.family))
        .add("corner", member.first)
        .add("turned_over", member.mirrored ? "yes" : "no")
        .add("fit", member.distance)
        .add("placement", std::span<const double>(placement));
  }
  return table.take();
}

TableText template_table(const CuttingPlan& plan) {
  const PanelTypes& types = plan.types->panels;
  TableWriter table;
  for (std::size_t k = 0; k < types.types.size(); ++k) {
    const PanelType& type = types.types[k];
    const auto turned = std::count_if(type.panels.begin(), type.panels.end(),
                                      [&](int face) { return types.panels[at(face)].mirrored; });
    table.row()
        .add("type", type_name(static_cast<int>(k)))
        .add("panels", static_cast<int>(type.panels.size()))
        .add("turned_over", static_cast<int>(turned))
        .add("corners", static_cast<int>(type.outline.cols()))
        .add("worst_fit", type.worst)
        .add("outline", std::span(type.outline.data(), at(type.outline.size())));
    add_measures(table, type.outline);
    table.add("area_of_all", area_of(type.outline) * static_cast<double>(type.panels.size()));
  }
  return table.take();
}

namespace {

/// Bars of one type.
struct BarKind {
  int first = -1;
  double least = std::numeric_limits<double>::infinity(), most = 0.0, all = 0.0;
};

}  // namespace

TableText bar_type_table(const CuttingPlan& plan) {
  const BarTypes& types = plan.types->bars;
  std::vector<BarKind> kinds(types.sizes.size());
  for (std::size_t j = 0; j < types.of_joint.size(); ++j) {
    BarKind& kind = kinds[at(types.of_joint[j])];
    const double length = plan.joints.joints[j].length;
    if (kind.first < 0) kind.first = static_cast<int>(j);
    kind.least = std::min(kind.least, length);
    kind.most = std::max(kind.most, length);
    kind.all += length;
  }
  TableWriter table;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const bool boundary = plan.joints.joints[at(kinds[k].first)].second.panel < 0;
    table.row()
        .add("type", bar_type_name(static_cast<int>(k)))
        .add("bars", types.sizes[k])
        .add("first", edge_name(kinds[k].first))
        .add("boundary", boundary ? "yes" : "no")
        .add("length_min", kinds[k].least)
        .add("length_max", kinds[k].most)
        .add("length_of_all", kinds[k].all);
  }
  return table.take();
}

TableText node_type_table(const CuttingPlan& plan) {
  const NodeTypes& types = plan.types->nodes;
  std::vector<int> bars(at(plan.mesh.vertex_count()), 0);
  for (const Joint& joint : plan.joints.joints) {
    ++bars[at(joint.from)];
    ++bars[at(joint.to)];
  }
  std::vector<int> first(types.sizes.size(), -1);
  for (std::size_t node = plan.vertex_of_node.size(); node-- > 0;) {
    first[at(types.of_vertex[at(plan.vertex_of_node[node])])] = static_cast<int>(node);
  }
  TableWriter table;
  for (std::size_t k = 0; k < first.size(); ++k) {
    table.row()
        .add("type", node_type_name(static_cast<int>(k)))
        .add("nodes", types.sizes[k])
        .add("first", node_name(first[k]))
        .add("bars", bars[at(plan.vertex_of_node[at(first[k])])]);
  }
  return table.take();
}

}  // namespace planish
