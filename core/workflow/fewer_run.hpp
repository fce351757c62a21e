// SPDX-License-Identifier: MIT
/// What `--merge` and `--collapse` of a cut take, do and tell.
#pragma once

#include <vector>

#include "planish/splitting/fewer_panels.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

[[nodiscard]] std::vector<OptionRow> fewer_option_rows();

/// Whether panels are to be merged or strips to go.
[[nodiscard]] bool asks_for_fewer(const Request& request);

/// Panels merged and strips gone, in the order given, and what the report says of it. Throws
/// RequestError.
struct FewerRun {
  Mesh mesh;
  Json report;
};
[[nodiscard]] FewerRun run_fewer(const Request& request, const Mesh& mesh,
                                 const Progress& progress);

}  // namespace planish::workflow
