// SPDX-License-Identifier: MIT
#include "fair_run.hpp"

#include <utility>

#include "planish/constraints/angle_limit.hpp"
#include "planish/constraints/fold_limit.hpp"
#include "planish/edit/fair_limits.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/panel_health.hpp"
#include "split_run.hpp"

namespace planish::workflow {

OptionRow fair_option_row() {
  return {kFairOption, "",
          "limits on how much folds sharpen and on the corners of slivers, where they\n"
          "cost the handles nothing and --bound has none; they are bounds of the design"};
}

bool asks_for_fair(const Request& request) {
  if (!request.has(kFairOption)) return false;
  for (const std::string_view other : {std::string_view("--fewest"), kSplitOption}) {
    if (!request.has(other)) continue;
    throw UsageError(std::string(kFairOption) + ": it knows no " + std::string(other));
  }
  return true;
}

namespace {

EditStanding standing_of(const FairTask& task, const HandleEditResult& result) {
  const Positions after = apply(task.base, result);
  const Adjacency adjacency = build_adjacency(task.base);
  const std::vector<int> touched = faces_of(adjacency, result.moved);
  return {
      .status = result.report.status,
      .moved_vertices = result.report.moved_vertices,
      .handle_error = farthest_handle(task.handles, after),
      .fold_growth = largest_fold_growth(task.base, adjacency, task.base.positions, after, touched),
      .slivers = count_new_slivers(task.base, task.given, after)};
}

bool stands(const SolveReport& report) {
  return report.usable() && report.status != SolveStatus::kCancelled;
}

}  // namespace

FairSolve solve_fairly(const FairTask& task, const DesignSteps& steps, HandleEditOptions& options,
                       const Progress& progress) {
  HandleEditSolver solver(task.base, options);
  FairSolve fair{{}, steps.edit(solver, progress)};
  if (!stands(fair.result.report)) return fair;
  const std::vector<StatedLimit> stated = options.bounds;
  const LimitedEdit limited =
      [&](const std::vector<StatedLimit>& limits) -> std::optional<EditStanding> {
    options.bounds = stated;
    options.bounds.insert(options.bounds.end(), limits.begin(), limits.end());
    solver.set_options(options);
    fair.result = steps.edit(solver, progress);
    if (!stands(fair.result.report)) return std::nullopt;
    return standing_of(task, fair.result);
  };
  const FairSearch search{.way = farthest_handle(task.handles, task.base.positions),
                          .folds = !has_limit(stated, FoldLimit::kName),
                          .corners = !has_limit(stated, AngleLimit::kName)};
  fair.found = find_fair_limits(standing_of(task, fair.result), search, limited);
  return fair;
}

Json fair_json(const std::vector<StatedLimit>& found) {
  Json limits = Json::array();
  for (const StatedLimit& limit : found) limits.push_back(stated_limit_text(limit));
  return {{"bounds", std::move(limits)}};
}

std::optional<std::string> fair_sentence(const std::vector<StatedLimit>& found) {
  if (found.empty()) return std::nullopt;
  std::string sentence = std::string(kFairOption) + ":";
  for (const StatedLimit& limit : found) sentence += " --bound " + stated_limit_text(limit);
  return sentence + ", with which the handles get as far";
}

}  // namespace planish::workflow
