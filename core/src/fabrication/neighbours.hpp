// SPDX-License-Identifier: MIT
/// What stands at the sides of a panel, by name.
#pragma once

#include <string>
#include <vector>

#include "planish/fabrication/cutting_plan.hpp"

namespace planish {

[[nodiscard]] const Joint& joint_at(const CuttingPlan& plan, int face, int side);

/// The panel beyond that side; below 0 there is none.
[[nodiscard]] int panel_beyond(const CuttingPlan& plan, int face, int side);

/// The panel beyond each side; "-" where there is none.
[[nodiscard]] std::vector<std::string> neighbour_names(const CuttingPlan& plan, int face);

/// The panel of that number; "-" below 0.
[[nodiscard]] std::string panel_or_nobody(const CuttingPlan& plan, int panel);

}  // namespace planish
