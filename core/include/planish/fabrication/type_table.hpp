// SPDX-License-Identifier: MIT
/// Which panel is of which type, how it lies on the template, and how many each type has.
#pragma once

#include "planish/fabrication/cutting_plan.hpp"
#include "planish/fabrication/panel_tables.hpp"

namespace planish {

/// One row a panel; the fields are described in docs/types.md.
/// @param plan with types
[[nodiscard]] TableText type_table(const CuttingPlan& plan);

/// One row a type: its template, and how many panels are cut from it. The same.
[[nodiscard]] TableText template_table(const CuttingPlan& plan);

}  // namespace planish
