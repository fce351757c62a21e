// SPDX-License-Identifier: MIT
#include "planish/fabrication/bar_types.hpp"

#include "numeric/trigonometry.hpp"
#include "planish/families/families.hpp"

namespace planish {

BarTypes find_bar_types(const JointTable& joints, double within, double degrees) {
  const double radians = degrees * kPi / 180.0;
  std::vector<FamilyShape> shapes;
  for (const Joint& joint : joints.joints) {
    // A cycle of one pair; of two for bars on the boundary, so that they are never alike.
    const Eigen::Vector2d pair(joint.dihedral / radians, joint.length / within);
    shapes.emplace_back(pair.replicate(1, joint.second.panel < 0 ? 2 : 1));
  }
  const Families families = find_families(shapes, {ShapeMeasure::kCycle, 1.0, false});
  BarTypes types;
  for (const FamilyMember& member : families.members) types.of_joint.push_back(member.family);
  types.sizes = families.sizes();
  return types;
}

}  // namespace planish
