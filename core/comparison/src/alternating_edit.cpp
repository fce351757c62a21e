// SPDX-License-Identifier: MIT
#include "engines/augmented_lagrangian.hpp"
#include "engines/edit_splitting.hpp"
#include "planish/comparison/methods.hpp"

namespace planish::comparison {

ComparedEdit edit_by_alternation(const EditTask& task, int inner_limit, int step_budget) {
  const MeshModel model(task.mesh, task.options.fairness);
  const EditProblem problem = pose(task, model, task.options.hard_handles);
  Patch patch = cut_all(problem);
  EditSplitting splitting(patch);
  AlmOptions options;
  options.max_inner = inner_limit;
  options.max_outer = step_budget;  // a dual update costs one step at least
  int left = step_budget;
  EngineOutcome run = run_alm(splitting, options, [&](const IterationRecord&) {
    left -= inner_limit;
    return left <= 0 ? Flow::kStop : Flow::kContinue;
  });
  ComparedEdit result;
  result.finished = run.status == SolveStatus::kConverged;
  result.steps = run.cost.steps;
  result.records = std::move(run.records);
  result.positions = displaced(model, patch);
  return result;
}

}  // namespace planish::comparison
