// SPDX-License-Identifier: MIT
/// Panels, edges and nodes as tables: enough, with nothing else, to build the mesh again.
#pragma once

#include <string>

#include "planish/fabrication/cutting_plan.hpp"

namespace planish {

/// One table, twice. CSV as RFC 4180 has it (UTF-8, decimal points; lists are separated by blanks);
/// JSON as an array of objects with the same fields. Numbers read back to the same bits.
struct TableText {
  std::string csv, json;
};

/// The fields are described in docs/fabrication.md.
[[nodiscard]] TableText panel_table(const CuttingPlan& plan);
[[nodiscard]] TableText edge_table(const CuttingPlan& plan);
[[nodiscard]] TableText node_table(const CuttingPlan& plan);

}  // namespace planish
