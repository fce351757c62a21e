// SPDX-License-Identifier: MIT
#include "planish/fabrication/type_table.hpp"

#include <array>
#include <span>

#include "fabrication/table_writer.hpp"
#include "planish/numeric/index.hpp"

namespace planish {

TableText type_table(const CuttingPlan& plan, const PanelTypes& types) {
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

}  // namespace planish
