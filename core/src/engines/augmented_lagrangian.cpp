// SPDX-License-Identifier: MIT
#include "engines/augmented_lagrangian.hpp"

#include <numeric>

#include "engines/edit_splitting.hpp"
#include "planish/index.hpp"

namespace planish {
namespace {

/// Runs the loop on one patch and leaves d in the field.
AlmRun run_on_patch(Patch& patch, const AlmOptions& options, const Progress& progress,
                    DisplacementField& field, AlmOutcome& outcome) {
  for (int k = 0; k < patch.free_count; ++k) {
    patch.displacement.col(k) = field.displacement(patch.vertices[at(k)]);
  }
  EditSplitting splitting(patch);
  AlmRun run = run_alm(splitting, options, progress);
  outcome.support.clear();
  for (const int k : splitting.support()) outcome.support.push_back(patch.vertices[at(k)]);
  for (const int v : field.touched_vertices()) field.reset_vertex(v);
  for (int k = 0; k < patch.free_count; ++k) {
    field.set_displacement(patch.vertices[at(k)], patch.displacement.col(k));
  }
  outcome.inner_steps += run.inner_steps;
  outcome.outer_steps += run.outer_steps;
  outcome.factorizations += splitting.factorizations();
  outcome.records.insert(outcome.records.end(), run.records.begin(), run.records.end());
  outcome.status = run.status;
  return run;
}

}  // namespace

AlmOutcome solve_edit_by_alm(const EditProblem& problem, const AlmOptions& options,
                             DisplacementField& field, const Progress& progress) {
  const MeshModel& model = *problem.model;
  AlmOutcome outcome;
  PatchCutter cutter(model.vertex_count(), model.mesh.face_count(),
                     static_cast<int>(model.fairness.rows()));
  std::vector<int> anywhere = problem.region;
  if (anywhere.empty()) {
    anywhere.resize(at(model.vertex_count()));
    std::iota(anywhere.begin(), anywhere.end(), 0);
  }
  Patch patch;
  cutter.cut(problem, anywhere, patch);
  (void)run_on_patch(patch, options, progress, field, outcome);
  const bool finished =
      outcome.status == SolveStatus::kConverged || outcome.status == SolveStatus::kIterationLimit;
  const SolveStatus whole = outcome.status;
  if (finished && problem.sparse) {
    // The support comes from y, never from d; the rest of the problem is solved on it alone.
    const std::vector<int> support = outcome.support;
    cutter.cut(problem, support, patch);
    (void)run_on_patch(patch, options, progress, field, outcome);
    outcome.support = support;
    if (whole != SolveStatus::kConverged) outcome.status = whole;
  }
  // Fixed handles are no unknowns, but they move.
  for (const int v : problem.handles) {
    if (problem.terms[at(v)].fixed) outcome.support.push_back(v);
  }
  std::sort(outcome.support.begin(), outcome.support.end());
  return outcome;
}

}  // namespace planish
