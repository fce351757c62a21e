// SPDX-License-Identifier: MIT
#include "planish/fabrication/structure_types.hpp"

#include "fabrication/numbered.hpp"

namespace planish {

StructureTypes find_structure_types(const Mesh& mesh, const std::vector<FlatPanel>& panels,
                                    const JointTable& joints, const TypeOptions& options) {
  StructureTypes types;
  types.panels = find_panel_types(panels, joints, options);
  types.nodes = find_node_types(mesh, joints, options.degrees, options.mirrored);
  types.bars = find_bar_types(joints, types.panels.within, options.degrees);
  return types;
}

std::string type_name(int type) { return numbered("T", type); }
std::string node_type_name(int type) { return numbered("NT", type); }
std::string bar_type_name(int type) { return numbered("BT", type); }

}  // namespace planish
