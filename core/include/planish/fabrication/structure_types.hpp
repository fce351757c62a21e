// SPDX-License-Identifier: MIT
/// What of a structure is alike: panels, nodes and bars by their types.
#pragma once

#include <string>
#include <vector>

#include "planish/fabrication/bar_types.hpp"
#include "planish/fabrication/node_types.hpp"
#include "planish/fabrication/panel_types.hpp"

namespace planish {

struct StructureTypes {
  PanelTypes panels;
  NodeTypes nodes;  ///< within options.degrees
  BarTypes bars;    ///< within that, and within panels.within
};

/// @param panels one a face of `mesh`, in its unit; @param joints of `mesh`
/// @param options must have no problem
[[nodiscard]] StructureTypes find_structure_types(const Mesh& mesh,
                                                  const std::vector<FlatPanel>& panels,
                                                  const JointTable& joints,
                                                  const TypeOptions& options);

/// "T-0001" for panel type 0; "NT-0001" for node type 0; "BT-0001" for bar type 0.
[[nodiscard]] std::string type_name(int type);
[[nodiscard]] std::string node_type_name(int type);
[[nodiscard]] std::string bar_type_name(int type);

}  // namespace planish
