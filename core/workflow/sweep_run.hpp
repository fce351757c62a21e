// SPDX-License-Identifier: MIT
/// What one job of a sweep leaves behind, and the table of all of them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "planish/sweep/sweep_plan.hpp"
#include "request.hpp"
#include "type_change.hpp"

namespace planish::workflow {

/// Throws RequestError.
[[nodiscard]] SweepPlan read_plan(const std::string& text);

/// The values of a job as a JSON object.
[[nodiscard]] std::string values_text(const SweepJob& job);

/// One job done. Both texts depend on the job and on what is counted alone: no times, no places.
struct SweepResult {
  std::string figures;  ///< JSON: id, values, report, or the sentence why there is no design
  std::string design;   ///< JSON with the mark of the result; "" if there is none
  std::string seconds;  ///< JSON: what it took here
};

/// Makes one design of a sweep. What is wrong with it alone is a result, too, and throws nothing.
[[nodiscard]] SweepResult run_job(const SweepJob& job,
                                  const std::optional<TypeCounting>& types = std::nullopt);

/// Writes the result to `folder`, <id>.json last: where that is present, the job is done.
void save_result(const std::string& folder, const std::string& id, const SweepResult& result);

[[nodiscard]] bool is_done(const std::string& folder, const std::string& id);

/// The table of all results in `folder` as CSV, sorted by id: the same bytes in whatever order,
/// and wherever, the jobs ran. Throws RequestError.
[[nodiscard]] std::string gather(const std::string& folder);

}  // namespace planish::workflow
