// SPDX-License-Identifier: MIT
/// What `--merge` and `--collapse` of a cut take, do and tell.
#pragma once

#include <vector>

#include "arguments.hpp"
#include "planish/splitting/fewer_panels.hpp"
#include "report.hpp"

namespace planish::cli {

[[nodiscard]] std::vector<OptionRow> fewer_option_rows();

/// Whether panels are to be merged or strips to go.
[[nodiscard]] bool asks_for_fewer(const Arguments& arguments);

/// Panels merged and strips gone, in the order given, and what the report says of it. Throws
/// CommandError.
struct FewerRun {
  Mesh mesh;
  Json report;
};
[[nodiscard]] FewerRun run_fewer(const Arguments& arguments, const Mesh& mesh,
                                 const Progress& progress);

}  // namespace planish::cli
