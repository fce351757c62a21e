// SPDX-License-Identifier: MIT
#include "planish/fabrication/type_table.hpp"

#include <algorithm>
#include <array>
#include <span>

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
        .add("panel", panel_name(f))
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

}  // namespace planish
