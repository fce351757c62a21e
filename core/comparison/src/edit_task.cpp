// SPDX-License-Identifier: MIT
#include "planish/comparison/edit_task.hpp"

#include <numeric>

#include "planish/numeric/index.hpp"

namespace planish::comparison {

EditProblem pose(const EditTask& task, const MeshModel& model, bool hold_handles) {
  EditProblem problem;
  problem.model = &model;
  problem.fairness_weight = task.options.smoothness;
  VertexTerm rest;
  if (task.options.sparsity == Sparsity::kL21) rest.norm_weight = task.options.locality;
  if (task.options.sparsity == Sparsity::kL2) rest.square_weight = task.options.locality;
  problem.seeks_support = rest.norm_weight > 0.0;
  problem.terms.assign(at(model.vertex_count()), rest);
  for (const Handle& handle : task.targets.handles) {
    VertexTerm& term = problem.terms[at(handle.vertex)];
    term = {.square_weight = task.options.attraction, .handle = true};
    term.target = (handle.target - task.mesh.positions.col(handle.vertex)) / model.unit();
    term.fixed = hold_handles;
    problem.handles.push_back(handle.vertex);
  }
  for (const int pin : task.targets.pins) problem.terms[at(pin)] = {.fixed = true};
  return problem;
}

Patch cut(const EditProblem& problem, const std::vector<int>& free) {
  const MeshModel& model = *problem.model;
  PatchCutter cutter(model);
  Patch patch;
  cutter.cut(problem, free, patch);
  return patch;
}

Patch cut_all(const EditProblem& problem) {
  std::vector<int> all(at(problem.model->vertex_count()));
  std::iota(all.begin(), all.end(), 0);
  return cut(problem, all);
}

Positions displaced(const MeshModel& model, const Patch& patch) {
  Positions positions = model.mesh.positions;
  for (int k = 0; k < patch.local_count(); ++k) {
    const Eigen::Vector3d d = patch.displacement.col(k);
    if (!d.isZero(0.0)) positions.col(patch.vertices[at(k)]) += model.unit() * d;
  }
  return positions;
}

}  // namespace planish::comparison
