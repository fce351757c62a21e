// SPDX-License-Identifier: MIT
/// What `types` takes and tells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "planish/fabrication/cutting_plan.hpp"
#include "report.hpp"
#include "shop_input.hpp"

namespace planish::cli {

[[nodiscard]] std::vector<OptionRow> types_option_rows();

/// What options ask for, lengths in `unit`. Throws CommandError.
[[nodiscard]] TypeOptions type_options(const Arguments& arguments, const Mesh& mesh,
                                       const std::string& model_unit, const std::string& unit);

/// Throws CommandError where `name` is not that of a table.
void check_types_name(const std::string& name);

/// A plan with types. Throws CommandError.
[[nodiscard]] CuttingPlan plan_types(const Arguments& arguments, const ShopInput& input);

[[nodiscard]] Json types_json(const CuttingPlan& plan);

/// The table of types as the file `name`. Throws CommandError.
/// @param plan with types
[[nodiscard]] std::string types_bytes(const std::string& name, const CuttingPlan& plan);

/// What whoever cuts by these types should know; one sentence each.
[[nodiscard]] std::vector<std::string> types_sentences(const CuttingPlan& plan, double tolerance);

}  // namespace planish::cli
