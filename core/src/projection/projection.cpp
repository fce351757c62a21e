// SPDX-License-Identifier: MIT
#include "planish/projection/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "planish/problem/mesh_standing.hpp"
#include "projection/nearly_flat.hpp"
#include "projection/projection_attempt.hpp"
#include "projection/projection_task.hpp"
#include "projection/sound_search.hpp"

namespace planish {
namespace {

/// Projects along the path to the flat mesh, no farther than asked for: by the α_f asked for, then
/// ten and a hundred times as much, because a fairer path goes farther before a panel bends.
ProjectionResult project_nearly(const ProjectionTask& task, const Progress& progress) {
  constexpr int kRings = 32;
  ProjectionOptions options = task.options;
  const double within =
      options.within > 0.0 ? options.within : std::numeric_limits<double>::infinity();
  const double asked = options.fairness_weight > 0.0 ? options.fairness_weight : 1.0;
  const std::vector<int> free = surroundings(task, MeshModel(task.mesh, options.fairness), kRings);
  ProjectionResult best;
  for (const double factor : {1.0, 10.0, 100.0}) {
    options.fairness_weight = factor * asked;
    NearlyFlat found = find_nearly_flat(task.mesh, options, within, free, progress);
    Mesh after = task.mesh;
    after.positions = std::move(found.positions);
    ProjectionResult next;
    next.report = std::move(found.report);
    next.fairness_weight = options.fairness_weight;
    conclude(task, after.positions, measure_standing(after, task.adjacency, task.kept), next);
    const bool first = factor == 1.0;
    const SolveStatus status = next.report.status;
    if (first || next.report.planarity_after < best.report.planarity_after) best = std::move(next);
    if (best.failing_faces.empty() || status == SolveStatus::kCancelled) break;
  }
  return best;
}

ProjectionResult project(const Mesh& mesh, const Positions* reference,
                         const ProjectionOptions& options, const std::vector<int>& pins,
                         const Progress& progress) {
  ProjectionResult result;
  result.moved_positions.resize(3, 0);
  const KeptKinds kept = kept_kinds(options.tolerance, options.constraints);
  const bool stars = kept.has_element(Element::kVertex);
  const Adjacency adjacency = stars ? build_adjacency(mesh) : Adjacency();
  Mesh history;
  if (reference != nullptr) {
    history = mesh;
    history.positions = *reference;
  }
  const Mesh& base = reference != nullptr ? history : mesh;
  const ProjectionTask task{mesh, base, reference, options,
                            pins, kept, adjacency, measure_standing(mesh, adjacency, kept)};
  add_violations(kept, task.before.worst, task.before.worst, result.report);
  result.report.status = SolveStatus::kConverged;
  if (task.before.failing.empty()) return result;  // flat already: the same bits
  if (options.no_flatter && reference == nullptr) return project_nearly(task, progress);
  // Fair meshes seldom need the bound, but the engine that knows it is the faster one as well.
  const bool fair = options.keep_shape && reference == nullptr && options.fairness_weight > 0.0 &&
                    options.engine == Engine::kNewton;
  if (fair) return SoundSearch(task, progress).run();
  const Positions after = project_freely(task, progress, result);
  if (!options.keep_shape || result.report.status == SolveStatus::kCancelled ||
      is_sound(task, after)) {
    return result;
  }
  if (reference != nullptr && options.engine == Engine::kNewton) {
    if (auto shaped = project_in_shape(task, progress)) return std::move(*shaped);
  }
  ProjectionResult sound = SoundSearch(task, progress).run();
  if (reference != nullptr) sound.confined_because = ConfinedBecause::kSpoiltPanels;
  say_if_confined(sound);
  // A variation must become flat; what that spoils is reported.
  return reference != nullptr && !sound.report.usable() ? result : sound;
}

}  // namespace

std::string_view reason(ConfinedBecause because) {
  switch (because) {
    case ConfinedBecause::kNothing:
      return "";
    case ConfinedBecause::kNotExact:
      return "the weighted distance was not minimised: its solve left panels above the tolerance";
    case ConfinedBecause::kSpoiltPanels:
      return "the weighted distance was not minimised: panels would have lost their shape";
    case ConfinedBecause::kStatedLimits:
      return "the variation came back towards the edit: panels would have exceeded a stated limit";
    case ConfinedBecause::kSpoiltByVariation:
      return "the variation came back towards the edit: panels would have lost their shape";
  }
  return "";
}

Refusal find_problem(const ProjectionOptions& options) {
  const auto weight = [](double value) { return std::isfinite(value) && value >= 0.0; };
  if (!weight(options.fairness_weight)) return "fairness_weight must be a number of at least 0";
  if (!weight(options.distance_weight) || options.distance_weight == 0.0) {
    return "distance_weight must be a number greater than 0";
  }
  if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance)) {
    return "tolerance must be a number greater than 0 (mm/m)";
  }
  if (auto problem = find_problem(options.constraints)) return problem;
  if (auto problem = find_problem(options.supports)) return problem;
  if (hold_points(options.supports)) {
    if (auto problem = find_problem(options.engine, Beyond::kSupports)) return problem;
  }
  const bool on_surfaces =
      std::any_of(options.supports.begin(), options.supports.end(),
                  [](const PointSupport& one) { return one.kind == PointSupport::Kind::kSurface; });
  if (on_surfaces && (options.within > 0.0 || options.no_flatter)) {
    return "support: points on a surface take no within, and no panels that stay less flat";
  }
  if (!std::isfinite(options.within) || options.within < 0.0) {
    return "within must be a length of at least 0";
  }
  if (options.max_iterations < 0) return "max_iterations must be at least 0";
  return std::nullopt;
}

ProjectionResult project_to_planar(const Mesh& mesh, const ProjectionOptions& options,
                                   const std::vector<int>& pins, const Progress& progress) {
  ProjectionResult flat = project(mesh, nullptr, options, pins, progress);
  const bool too_far = options.within > 0.0 && flat.max_move > options.within;
  if (!too_far || options.no_flatter || flat.report.status == SolveStatus::kCancelled) return flat;
  if (options.fairness_weight > 0.0) {
    ProjectionOptions near = options;
    near.fairness_weight = 0.0;
    ProjectionResult nearest = project(mesh, nullptr, near, pins, progress);
    if (nearest.report.usable() && nearest.max_move <= options.within) return nearest;
  }
  ProjectionOptions short_of_it = options;
  short_of_it.no_flatter = true;
  return project(mesh, nullptr, short_of_it, pins, progress);
}

ProjectionResult project_to_planar(const Mesh& mesh, const Positions& reference,
                                   const ProjectionOptions& options, const std::vector<int>& pins,
                                   const Progress& progress) {
  return project(mesh, &reference, options, pins, progress);
}

}  // namespace planish
