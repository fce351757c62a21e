// SPDX-License-Identifier: MIT
#include "engines/augmented_lagrangian.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engines/edit_splitting.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Runs the loop on one patch and leaves d in the field; the patch's factors are counted.
EngineOutcome run_on_patch(Patch& patch, const AlmOptions& options, const Progress& progress,
                           DisplacementField& field, std::vector<int>& support) {
  for (int k = 0; k < patch.free_count; ++k) {
    patch.displacement.col(k) = field.displacement(patch.vertices[at(k)]);
  }
  EditSplitting splitting(patch, options.executor);
  EngineOutcome run = run_alm(splitting, options, progress);
  support.clear();
  for (const int k : splitting.support()) support.push_back(patch.vertices[at(k)]);
  for (const int v : field.touched_vertices()) field.reset_vertex(v);
  for (int k = 0; k < patch.free_count; ++k) {
    field.set_displacement(patch.vertices[at(k)], patch.displacement.col(k));
  }
  run.cost.factorizations = splitting.factorizations();
  return run;
}

/// `first`, and what was done after it; its status stands unless the first converged.
void append(EngineOutcome first, EngineOutcome& then) {
  then.cost += first.cost;
  first.records.insert(first.records.end(), then.records.begin(), then.records.end());
  then.records = std::move(first.records);
  if (first.status != SolveStatus::kConverged) then.status = first.status;
}

}  // namespace

EngineOutcome solve_edit_by_alm(const EditProblem& problem, const AlmOptions& options,
                                DisplacementField& field, std::vector<int>& support,
                                const Progress& progress) {
  const MeshModel& model = *problem.model;
  PatchCutter cutter(model);
  std::vector<int> anywhere = problem.region;
  if (anywhere.empty()) {
    anywhere.resize(at(model.vertex_count()));
    std::iota(anywhere.begin(), anywhere.end(), 0);
  }
  Patch patch;
  cutter.cut(problem, anywhere, patch);
  EngineOutcome outcome = run_on_patch(patch, options, progress, field, support);
  const bool finished =
      outcome.status == SolveStatus::kConverged || outcome.status == SolveStatus::kIterationLimit;
  if (finished && problem.seeks_support) {
    // The support comes from y, never from d; the rest of the problem is solved on it alone.
    cutter.cut(problem, support, patch);
    std::vector<int> rest;
    EngineOutcome then = run_on_patch(patch, options, progress, field, rest);
    append(std::move(outcome), then);
    outcome = std::move(then);
  }
  // Fixed handles are no unknowns, but they move.
  for (const int v : problem.handles) {
    if (problem.terms[at(v)].fixed) support.push_back(v);
  }
  std::sort(support.begin(), support.end());
  return outcome;
}

}  // namespace planish
