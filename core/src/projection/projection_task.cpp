// SPDX-License-Identifier: MIT
#include "projection/projection_task.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engines/working_set.hpp"
#include "planish/numeric/index.hpp"
#include "projection/sound_projection.hpp"

namespace planish {

void record_moves(const Positions& before, const Positions& after, ProjectionResult& result) {
  result.moved.clear();
  result.max_move = 0.0;
  double squares = 0.0;
  for (int v = 0; v < after.cols(); ++v) {
    const double move = (after.col(v) - before.col(v)).norm();
    if (move == 0.0) continue;
    result.moved.push_back(v);
    squares += move * move;
    result.max_move = std::max(result.max_move, move);
  }
  result.moved_positions = after(Eigen::all, result.moved);
  result.rms_move =
      std::sqrt(squares / static_cast<double>(std::max<Eigen::Index>(1, after.cols())));
  result.report.moved_vertices = static_cast<int>(result.moved.size());
  result.report.max_displacement = result.max_move;
}

void add_violations(const KeptKinds& kept, const Violations& before, const Violations& after,
                    SolveReport& report) {
  report.violations = kind_violations(kept, before, after);
  report.planarity_before = report.violations.front().before_max;
  report.planarity_after = report.violations.front().after_max;
}

void conclude(const ProjectionTask& task, const Positions& positions, MeshStanding after,
              ProjectionResult& result) {
  record_moves(task.mesh.positions, positions, result);
  add_violations(task.kept, task.before.worst, after.worst, result.report);
  result.failing_faces = std::move(after.failing);
  if (!result.failing_faces.empty() && result.report.usable()) {
    result.report.status = SolveStatus::kToleranceNotMet;
  } else if (result.failing_faces.empty() && result.report.status == SolveStatus::kSingularSystem) {
    result.report.status = SolveStatus::kIterationLimit;
  }
}

void say_if_confined(ProjectionResult& result) {
  if (result.confined_because == ConfinedBecause::kNothing) return;
  result.report.optimality.reset();
  if (result.report.usable()) result.report.status = SolveStatus::kNearestConfined;
}

bool is_sound(const ProjectionTask& task, const Positions& after) {
  return spoilt_faces(task.mesh, task.base.positions, after).empty() &&
         tipped_faces(task.mesh, task.mesh.positions, after).empty();
}

std::vector<int> surroundings(const ProjectionTask& task, const MeshModel& model, int rings) {
  WorkingSetGrower grower(model);
  std::vector<int> pins = task.pins;
  std::sort(pins.begin(), pins.end());
  std::vector<int> free;
  for (const int v : grower.grow(vertices_of(task.mesh, task.before.failing), rings)) {
    if (!std::binary_search(pins.begin(), pins.end(), v)) free.push_back(v);
  }
  return free;
}

}  // namespace planish
