// SPDX-License-Identifier: MIT
/// Which bars are alike: those along the edges, by their length and the angle of their panels.
#pragma once

#include <vector>

#include "planish/fabrication/joints.hpp"

namespace planish {

struct BarTypes {
  std::vector<int> of_joint;  ///< the type of each bar
  std::vector<int> sizes;     ///< bars of each type, the most first
};

/// Bars of one type are `within` of one length and `degrees` of one dihedral angle; bars on the
/// boundary have types of their own.
/// @param within in the unit of the joints' lengths
[[nodiscard]] BarTypes find_bar_types(const JointTable& joints, double within, double degrees);

}  // namespace planish
