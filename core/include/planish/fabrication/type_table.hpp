// SPDX-License-Identifier: MIT
/// Which panel is of which type, and how it lies on the template.
#pragma once

#include "planish/fabrication/cutting_plan.hpp"
#include "planish/fabrication/panel_tables.hpp"
#include "planish/fabrication/panel_types.hpp"

namespace planish {

/// One row a panel; the fields are described in docs/types.md.
[[nodiscard]] TableText type_table(const CuttingPlan& plan, const PanelTypes& types);

}  // namespace planish
