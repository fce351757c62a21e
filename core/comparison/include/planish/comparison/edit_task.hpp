// SPDX-License-Identifier: MIT
/// One edit, posed alike to every method that is compared, and what a method made of it.
#pragma once

#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/problem/problem.hpp"
#include "planish/problem/solve_report.hpp"

namespace planish::comparison {

/// The edit: a flat mesh, handles with targets, weights of (3).
struct EditTask {
  Mesh mesh;
  EditTargets targets;
  HandleEditOptions options;
};

/// A method's answer, unjudged: it may break constraints or miss the handles.
struct ComparedEdit {
  Positions positions;                   ///< 3 × n, model units
  bool finished = false;                 ///< whether the method met its own stopping rule
  int steps = 0;                         ///< iterations, as the method counts them
  std::vector<IterationRecord> records;  ///< where the method has outer steps
};

/// (3) with the terms of `task`; handles are fixed to their targets if `hold_handles`.
/// @param model of task.mesh; must outlive the problem
[[nodiscard]] EditProblem pose(const EditTask& task, const MeshModel& model, bool hold_handles);

/// The whole mesh or some of its vertices as a patch of `problem`.
[[nodiscard]] Patch cut(const EditProblem& problem, const std::vector<int>& free);
[[nodiscard]] Patch cut_all(const EditProblem& problem);

/// The base mesh with a patch's displacement, halo included.
[[nodiscard]] Positions displaced(const MeshModel& model, const Patch& patch);

}  // namespace planish::comparison
