// SPDX-License-Identifier: MIT
/// Which nodes are alike: by the angles of the panels and of the folds around them.
#pragma once

#include <vector>

#include "planish/fabrication/joints.hpp"
#include "planish/families/families.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

struct NodeTypes {
  std::vector<int> of_vertex;  ///< the type of each node; −1 for a vertex without panels
  std::vector<int> sizes;      ///< nodes of each type, the most first
};

/// What stands around each vertex, radians: the angle of each panel there, and the dihedral angle
/// of the edge before it, anticlockwise as seen from outside; on the boundary also what is open,
/// which no panel can be taken for. No columns for a vertex without panels.
[[nodiscard]] std::vector<FamilyShape> node_cycles(const Mesh& mesh, const JointTable& joints);

/// Nodes of one type have all these angles within `degrees` of the same.
/// @param mirrored mirror images belong to one type
[[nodiscard]] NodeTypes find_node_types(const Mesh& mesh, const JointTable& joints, double degrees,
                                        bool mirrored);

}  // namespace planish
