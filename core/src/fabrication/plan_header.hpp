// SPDX-License-Identifier: MIT
/// What a package and a model say of themselves.
#pragma once

#include <string_view>
#include <vector>

#include "fabrication/json_object.hpp"
#include "planish/fabrication/cutting_plan.hpp"

namespace planish {

/// Sets `flatness` and `excess` of the worst panel.
void measure_flatness(const CuttingPlan& plan, DrawnReport& report);

/// The fields that both have, see docs/fabrication.md.
[[nodiscard]] JsonObject plan_header(std::string_view format, const CuttingPlan& plan,
                                     const DrawnReport& report);

}  // namespace planish
