// SPDX-License-Identifier: MIT
#include "fabrication/neighbours.hpp"

#include "planish/numeric/index.hpp"

namespace planish {

const Joint& joint_at(const CuttingPlan& plan, int face, int side) {
  const auto place = at(plan.mesh.face_offsets[at(face)] + side);
  return plan.joints.joints[at(plan.joints.of_side[place])];
}

int panel_beyond(const CuttingPlan& plan, int face, int side) {
  const Joint& joint = joint_at(plan, face, side);
  const bool is_first = joint.first.panel == face && joint.first.side == side;
  return is_first ? joint.second.panel : joint.first.panel;
}

std::string panel_or_nobody(const CuttingPlan& plan, int panel) {
  return panel < 0 ? "-" : plan.options.names.of(panel);
}

std::vector<std::string> neighbour_names(const CuttingPlan& plan, int face) {
  std::vector<std::string> names;
  const int sides = static_cast<int>(plan.mesh.face(face).size());
  names.reserve(at(sides));
  for (int k = 0; k < sides; ++k)
    names.push_back(panel_or_nobody(plan, panel_beyond(plan, face, k)));
  return names;
}

}  // namespace planish
