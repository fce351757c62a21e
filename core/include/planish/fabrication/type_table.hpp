// SPDX-License-Identifier: MIT
/// Which panel is of which type, how it lies on the template, and how many each type has.
#pragma once

#include "planish/fabrication/cutting_plan.hpp"
#include "planish/fabrication/panel_tables.hpp"

namespace planish {

/// A table of one row a panel; the fields are described in docs/types.md.
/// @param plan with types
[[nodiscard]] TableText type_table(const CuttingPlan& plan);

/// A table of one row a type: its template, and how many panels are cut from it. @param plan with
/// types
[[nodiscard]] TableText template_table(const CuttingPlan& plan);

/// Tables of one row a type of bars, and of nodes: how many there are, and what they measure.
/// @param plan with types
[[nodiscard]] TableText bar_type_table(const CuttingPlan& plan);
[[nodiscard]] TableText node_type_table(const CuttingPlan& plan);

}  // namespace planish
