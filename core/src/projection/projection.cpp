// SPDX-License-Identifier: MIT
#include "planish/projection/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "engines/tangent_newton.hpp"
#include "engines/working_set.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "planish/problem/mesh_standing.hpp"
#include "problem/shape_slides.hpp"
#include "projection/nearly_flat.hpp"
#include "projection/projector.hpp"
#include "projection/sound_projection.hpp"

namespace planish {
namespace {

constexpr int kRounds = 3;  ///< how often planes may be carried by other vertices

/// What moved from `mesh` to `after`, and how far.
void record_moves(const Mesh& mesh, const Positions& after, ProjectionResult& result) {
  double squares = 0.0;
  result.moved.clear();
  result.max_move = 0.0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double move = (after.col(v) - mesh.positions.col(v)).norm();
    if (move == 0.0) continue;
    result.moved.push_back(v);
    squares += move * move;
    result.max_move = std::max(result.max_move, move);
  }
  result.moved_positions.resize(3, static_cast<Eigen::Index>(result.moved.size()));
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    result.moved_positions.col(static_cast<Eigen::Index>(k)) = after.col(result.moved[k]);
  }
  result.rms_move = std::sqrt(squares / std::max(1, mesh.vertex_count()));
  result.report.moved_vertices = static_cast<int>(result.moved.size());
  result.report.max_displacement = result.max_move;
}

void add_violations(const KeptKinds& kept, const Violations& before, const Violations& after,
                    SolveReport& report) {
  report.violations = kind_violations(kept, before, after);
  report.planarity_before = report.violations.front().before_max;
  report.planarity_after = report.violations.front().after_max;
}

/// One projection: what was given, and how flat it was.
struct Task {
  const Mesh& mesh;
  const Mesh& base;            ///< of the history, or `mesh`: what supports are about
  const Positions* reference;  ///< null without a history
  const ProjectionOptions& options;
  const std::vector<int>& pins;
  const KeptKinds& kept;
  const Adjacency& adjacency;  ///< empty unless a kept kind hangs on stars
  MeshStanding before;
};

/// How one attempt is made.
enum class Attempt { kNearest, kConfined, kWeighted, kWeightedInShape };

/// Attempts from `current` until no panel fails or the rounds are over. A large correction can make
/// the vertices that carry a panel's plane collinear; the next round chooses them anew.
/// @param rings about the panels that fail, where confined
ProjectionResult attempt(const Task& task, Attempt kind, int rings, Mesh& current,
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
    step.report.iterations += result.report.iterations;
    step.report.factorizations += result.report.factorizations;
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

/// What a projection came to; `positions` are 3 × n.
void conclude(const Task& task, const Positions& positions, MeshStanding after,
              ProjectionResult& result) {
  record_moves(task.mesh, positions, result);
  add_violations(task.kept, task.before.worst, after.worst, result.report);
  result.failing_faces = std::move(after.failing);
  if (!result.failing_faces.empty() && result.report.usable()) {
    result.report.status = SolveStatus::kToleranceNotMet;
  } else if (result.failing_faces.empty() && result.report.status == SolveStatus::kSingularSystem) {
    result.report.status = SolveStatus::kIterationLimit;
  }
}

/// What was solved in place of (8) is not its solution, whatever its own engine says.
void say_if_confined(ProjectionResult& result) {
  if (result.confined_because == ConfinedBecause::kNothing) return;
  result.report.optimality.reset();
  if (result.report.usable()) result.report.status = SolveStatus::kNearestConfined;
}

/// Whether no panel lost its shape or was tipped over.
bool is_sound(const Task& task, const Positions& after) {
  return spoilt_faces(task.mesh, task.base.positions, after).empty() &&
         tipped_faces(task.mesh, task.mesh.positions, after).empty();
}

/// Whatever becomes of the panels' shape.
Positions project_freely(const Task& task, const Progress& progress, ProjectionResult& result) {
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

/// The weighted distance with the bound on every panel's shape; nullopt where that does not end
/// with panels that are all flat and sound.
std::optional<ProjectionResult> project_in_shape(const Task& task, const Progress& progress) {
  Mesh current = task.mesh;
  MeshStanding after = task.before;
  ProjectionResult result = attempt(task, Attempt::kWeightedInShape, 0, current, after, progress);
  if (!after.failing.empty() || !result.report.usable()) return std::nullopt;
  if (!spoilt_faces(task.mesh, *task.reference, current.positions).empty()) return std::nullopt;
  result.fairness_weight = task.options.fairness_weight;
  conclude(task, current.positions, std::move(after), result);
  return result;
}

/// The vertices within `rings` face rings of the failing panels, pins left out.
std::vector<int> surroundings(const Task& task, const MeshModel& model, int rings) {
  WorkingSetGrower grower(model);
  std::vector<int> pins = task.pins;
  std::sort(pins.begin(), pins.end());
  std::vector<int> free;
  for (const int v : grower.grow(vertices_of(task.mesh, task.before.failing), rings)) {
    if (!std::binary_search(pins.begin(), pins.end(), v)) free.push_back(v);
  }
  return free;
}

/// As fair as asked for, with every panel's shape kept. Where that is not flat, sound and
/// certified, or far away, the nearest flat mesh if it is sound; then less fair, which asks less of
/// a panel that folds or tips over; then, for panels that are not flat yet, fairer, since a smooth
/// displacement seldom folds one.
class SoundSearch {
 public:
  SoundSearch(const Task& task, const Progress& progress) : task_(task), progress_(progress) {}

  [[nodiscard]] ProjectionResult run();

 private:
  static constexpr Rung kAsked[] = {{1.0, false}, {1.0, true}};
  static constexpr Rung kLessFair[] = {{0.1, false}, {0.1, true}};
  static constexpr Rung kFairer[] = {{10.0, true}, {100.0, true}};

  [[nodiscard]] SoundProjection project_around(std::span<const Rung> ladder) const;
  void climb(std::span<const Rung> ladder);
  [[nodiscard]] std::optional<ProjectionResult> nearest() const;
  [[nodiscard]] bool is_done() const;
  [[nodiscard]] bool goes_far() const;
  [[nodiscard]] bool is_half_as_far(double squared_move) const {
    return squared_move < 0.25 * best_.squared_move;
  }
  [[nodiscard]] ProjectionResult result();

  const Task& task_;
  const Progress& progress_;
  SoundProjection best_;
};

/// In growing surroundings of the panels that fail.
SoundProjection SoundSearch::project_around(std::span<const Rung> ladder) const {
  const MeshModel model(task_.mesh, task_.options.fairness);
  const int everything = task_.mesh.vertex_count();
  std::vector<int> last;
  SoundProjection best;
  for (const int rings : {8, 32, task_.reference != nullptr ? 32 : everything}) {
    std::vector<int> free = surroundings(task_, model, rings);
    if (free.size() == last.size()) continue;
    SoundProjection next =
        project_soundly(task_.mesh, task_.base, task_.options, free, task_.pins, ladder, progress_);
    const bool cancelled = next.report.status == SolveStatus::kCancelled;
    if (next.is_better_than(best)) best = std::move(next);
    if (cancelled || best.is_flat()) break;
    last = std::move(free);
  }
  return best;
}

/// Keeps the better one; a flat one gives way only to what is half as far.
void SoundSearch::climb(std::span<const Rung> ladder) {
  SoundProjection other = project_around(ladder);
  const int iterations = best_.report.iterations + other.report.iterations;
  const int factorizations = best_.report.factorizations + other.report.factorizations;
  const bool cancelled = other.report.status == SolveStatus::kCancelled;
  const bool stays = best_.is_flat() && !is_half_as_far(other.squared_move);
  if (!stays && other.is_better_than(best_)) best_ = std::move(other);
  if (cancelled) best_.report.status = SolveStatus::kCancelled;
  best_.report.iterations = iterations;
  best_.report.factorizations = factorizations;
}

/// The nearest flat mesh, where it is sound as it is and better than what was found.
std::optional<ProjectionResult> SoundSearch::nearest() const {
  ProjectionOptions options = task_.options;
  options.fairness_weight = 0.0;
  const Task task{task_.mesh, task_.base, task_.reference, options,
                  task_.pins, task_.kept, task_.adjacency, task_.before};
  ProjectionResult result;
  const Positions after = project_freely(task, progress_, result);
  if (!result.report.usable() || !is_sound(task, after)) return std::nullopt;
  const double squares = result.rms_move * result.rms_move * task.mesh.vertex_count();
  if (best_.is_flat() && !is_half_as_far(squares)) return std::nullopt;
  result.report.iterations += best_.report.iterations;
  result.report.factorizations += best_.report.factorizations;
  return result;
}

/// Nothing better need be looked for. What has more points than are factored is never looked at
/// twice once it is flat.
bool SoundSearch::is_done() const {
  if (best_.report.status == SolveStatus::kCancelled) return true;
  return task_.mesh.vertex_count() > kMostFactored ? best_.is_flat() : best_.is_final();
}

/// Whether points move so far that another mesh may be meant: a strong α_f bends and stretches a
/// panel rather than let its corners move against each other.
bool SoundSearch::goes_far() const {
  constexpr double kFar = 1.0;  // mean edges
  if (!best_.found() || task_.mesh.vertex_count() > kMostFactored) return false;
  const Positions moves = best_.positions - task_.mesh.positions;
  return moves.colwise().norm().maxCoeff() > kFar * mean_edge_length(task_.mesh);
}

ProjectionResult SoundSearch::run() {
  best_ = project_around(kAsked);
  const bool was_asked = task_.reference == nullptr && task_.options.fairness_weight > 0.0;
  const bool looks_on = was_asked ? !is_done() || goes_far() : !is_done() && !best_.is_flat();
  if (looks_on && best_.report.status != SolveStatus::kCancelled) {
    if (was_asked) {
      if (auto other = nearest()) return std::move(*other);
    }
    climb(kLessFair);
  }
  if (!is_done() && !best_.is_flat()) climb(kFairer);
  return result();
}

/// With a history, what does not become flat stays as it is: a variation half made exact is of no
/// use.
ProjectionResult SoundSearch::result() {
  ProjectionResult result;
  result.report = std::move(best_.report);
  result.fairness_weight = best_.fairness_weight;
  const bool useful = task_.reference == nullptr ? best_.found() : best_.is_flat();
  Mesh after = task_.mesh;
  if (useful) after.positions = std::move(best_.positions);
  conclude(task_, after.positions, measure_standing(after, task_.adjacency, task_.kept), result);
  return result;
}

/// On the path to the flat mesh, no farther than asked for: by the α_f asked for, then ten and a
/// hundred times as much, because a fairer path goes farther before a panel bends.
ProjectionResult project_nearly(const Task& task, const Progress& progress) {
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
  const Task task{mesh, base, reference, options,
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
  if (options.engine == Engine::kAugmentedLagrangian && hold_points(options.supports)) {
    return "support: the solver alm knows none";
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
