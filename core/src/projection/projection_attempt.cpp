// SPDX-License-Identifier: MIT
#include "projection/projection_attempt.hpp"

#include <utility>

#include "problem/shape_slides.hpp"
#include "projection/projector.hpp"
#include "projection/sound_projection.hpp"

namespace planish {
namespace {

constexpr int kRounds = 3;  ///< how often planes may be carried by other vertices

/// How one attempt is made.
enum class Attempt { kNearest, kConfined, kWeighted, kWeightedInShape };

/// Attempts from `current` until no panel fails or the rounds are over. A large correction can make
/// the vertices that carry a panel's plane collinear; the next round chooses them anew.
/// @param rings about the panels that fail, where confined
ProjectionResult attempt(const ProjectionTask& task, Attempt kind, int rings, Mesh& current,
                         MeshStanding& standing, const Progress& progress) {
  ProjectionResult result;
  for (int round = 0; round < kRounds && !standing.failing.empty(); ++round) {
    Projector projector(current, task.options, task.pins);
    if (hold_points(task.options.supports)) projector.stand_on(task.base);
    if (kind == Attempt::kWeighted || kind == Attempt::kWeightedInShape) {
      projector.penalise_unmoved(*task.reference);
      if (kind == Attempt::kWeightedInShape) projector.keep_shape();
    } else {
      projector.penalise_squares();
    }
    if (kind == Attempt::kConfined) projector.confine(standing.failing, rings);
    ProjectionResult step = projector.run(standing.failing, progress);
    for (std::size_t k = 0; k < step.moved.size(); ++k) {
      current.positions.col(step.moved[k]) = step.moved_positions.col(static_cast<Eigen::Index>(k));
    }
    standing = measure_standing(current, task.adjacency, task.kept);
    step.report.cost += result.report.cost;
    step.report.solve_seconds += result.report.solve_seconds;
    if (round > 0) step.report.optimality.reset();  // of the last round's problem, not of the whole
    if (round > 0 && step.report.status == SolveStatus::kConverged) {
      step.report.status = SolveStatus::kIterationLimit;
    }
    result.report = std::move(step.report);
    if (!result.report.usable()) break;
  }
  return result;
}

}  // namespace

Positions project_freely(const ProjectionTask& task, const Progress& progress,
                         ProjectionResult& result) {
  Mesh current = task.mesh;
  MeshStanding after = task.before;
  const bool has_history = task.reference != nullptr;
  result = attempt(task, has_history ? Attempt::kWeighted : Attempt::kNearest, 0, current, after,
                   progress);
  // Where the weighted problem does not close, the nearest flat mesh in growing surroundings does,
  // and still leaves the rest alone.
  for (const int rings : {2, 4, 8, 16}) {
    if (after.failing.empty() || !has_history || result.report.status == SolveStatus::kCancelled) {
      break;
    }
    Mesh again = task.mesh;
    MeshStanding left = task.before;
    ProjectionResult next = attempt(task, Attempt::kConfined, rings, again, left, progress);
    if (left.failing.size() > after.failing.size()) continue;
    result = std::move(next);
    result.confined_because = ConfinedBecause::kNotExact;
    current = std::move(again);
    after = std::move(left);
  }
  result.fairness_weight = task.options.fairness_weight;
  conclude(task, current.positions, std::move(after), result);
  say_if_confined(result);
  return std::move(current.positions);
}

std::optional<ProjectionResult> project_in_shape(const ProjectionTask& task,
                                                 const Progress& progress) {
  Mesh current = task.mesh;
  MeshStanding after = task.before;
  ProjectionResult result = attempt(task, Attempt::kWeightedInShape, 0, current, after, progress);
  if (!after.failing.empty() || !result.report.usable()) return std::nullopt;
  if (!spoilt_faces(task.mesh, *task.reference, current.positions).empty()) return std::nullopt;
  result.fairness_weight = task.options.fairness_weight;
  conclude(task, current.positions, std::move(after), result);
  return result;
}

}  // namespace planish
