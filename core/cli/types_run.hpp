// SPDX-License-Identifier: MIT
/// What `types` takes and tells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "planish/fabrication/bar_types.hpp"
#include "planish/fabrication/cutting_plan.hpp"
#include "planish/fabrication/node_types.hpp"
#include "planish/fabrication/panel_types.hpp"
#include "report.hpp"
#include "shop_input.hpp"

namespace planish::cli {

/// Types of a design, in the unit of its plan.
struct TypesRun {
  CuttingPlan plan;
  PanelTypes panels;
  NodeTypes nodes;
  BarTypes bars;
};

[[nodiscard]] std::vector<OptionRow> types_option_rows();

/// What options ask for, lengths in `unit`. Throws CommandError.
[[nodiscard]] TypeOptions type_options(const Arguments& arguments, const Mesh& mesh,
                                       const std::string& model_unit, const std::string& unit);

/// Throws CommandError.
[[nodiscard]] TypesRun run_types(const Arguments& arguments, const ShopInput& input);

[[nodiscard]] Json types_json(const TypesRun& run);

/// What whoever cuts by these types should know; one sentence each.
[[nodiscard]] std::vector<std::string> types_sentences(const TypesRun& run, double tolerance);

}  // namespace planish::cli
