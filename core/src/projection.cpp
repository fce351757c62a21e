// SPDX-License-Identifier: MIT
#include "planish/projection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engines/augmented_lagrangian.hpp"
#include "engines/exact_finish.hpp"
#include "engines/nearest_flat.hpp"
#include "engines/working_set_newton.hpp"
#include "planish/adjacency.hpp"
#include "planish/index.hpp"
#include "planish/mesh_standing.hpp"
#include "planish/stopwatch.hpp"
#include "sound_projection.hpp"

namespace planish {
namespace {

constexpr int kNewtonLimit = 100;
constexpr int kRounds = 3;  ///< how often planes may be carried by other vertices

/// One projection: the problem, the engine that suits it, and the result.
class Projector {
 public:
  Projector(const Mesh& mesh, const ProjectionOptions& options, const std::vector<int>& pins)
      : options_(options),
        kept_(kept_kinds(options.tolerance, options.constraints)),
        model_(mesh, options.fairness, kept_),
        field_(model_.vertex_count(), static_cast<int>(model_.equations.size())) {
    problem_.model = &model_;
    problem_.fairness_weight = 2.0 * options.fairness_weight;
    problem_.terms.resize(at(model_.vertex_count()));
    for (const int v : pins) problem_.terms[at(v)].fixed = true;
  }

  /// α_d ‖t̃‖², every vertex free. [PRO-2]
  void penalise_squares() {
    problem_.seeks_support = false;
    for (VertexTerm& term : problem_.terms) term.square_weight = 2.0 * options_.distance_weight;
  }

  /// α_d Σ w_i ‖t̃_i‖ with w_i = s / (s + ‖p̃_i − p⁰_i‖): 1 where nothing moved yet. [PRO-3]
  void penalise_unmoved(const Positions& reference) {
    problem_.seeks_support = true;
    const Positions moved = (model_.mesh.positions - reference) / model_.unit();
    const double largest = moved.cols() > 0 ? moved.colwise().norm().maxCoeff() : 0.0;
    const double soft = std::max(0.05 * largest, 1e-6);
    for (int v = 0; v < model_.vertex_count(); ++v) {
      const double weight = soft / (soft + moved.col(v).norm());
      problem_.terms[at(v)].norm_weight = 2.0 * options_.distance_weight * weight;
    }
  }

  ProjectionResult run(const std::vector<int>& failing, const Progress& progress);

  /// Only vertices within `rings` face rings of the failing faces may move.
  void confine(const std::vector<int>& failing, int rings) {
    WorkingSetGrower grower(model_);
    free_ = grower.grow(vertices_of(model_.mesh, failing), rings);
  }

 private:
  void solve_nearest(const Progress& progress);
  void solve_newton(const std::vector<int>& failing, const Progress& progress);
  void solve_augmented_lagrangian(const Progress& progress);
  [[nodiscard]] std::vector<int> everything() const {
    std::vector<int> all(at(model_.vertex_count()));
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  ProjectionOptions options_;
  KeptKinds kept_;
  MeshModel model_;
  EditProblem problem_;
  DisplacementField field_;
  std::vector<int> free_;  ///< empty: every vertex
  std::vector<int> support_;
  SolveReport report_;
};

void Projector::solve_nearest(const Progress& progress) {
  support_ = free_.empty() ? everything() : free_;
  PatchCutter cutter(model_.vertex_count(), model_.mesh.face_count(),
                     static_cast<int>(model_.fairness.rows()));
  Patch patch;
  cutter.cut(problem_, support_, patch);
  Eigen::Matrix3Xd displacement = Eigen::Matrix3Xd::Zero(3, patch.free_count);
  NearestFlatOptions nearest;
  if (options_.max_iterations > 0) nearest.max_steps = options_.max_iterations;
  // Who asks for fabrication's tolerance only need not wait for the last digits of the distance.
  nearest.settled = std::clamp(0.01 * options_.tolerance, nearest.settled, 1e-3);
  EngineOutcome outcome = find_nearest_flat(patch, nearest, progress, displacement);
  for (int k = 0; k < patch.free_count; ++k) {
    field_.set_displacement(patch.vertices[at(k)], displacement.col(k));
  }
  report_.status = outcome.status;
  report_.iterations = outcome.steps;
  report_.factorizations = outcome.factorizations;
  report_.records = std::move(outcome.records);
}

void Projector::solve_newton(const std::vector<int>& failing, const Progress& progress) {
  WorkingSetNewton newton(model_);
  NewtonOptions options;
  options.max_steps = options_.max_iterations > 0 ? options_.max_iterations : 2 * kNewtonLimit;
  const std::vector<int> seeds = vertices_of(model_.mesh, failing);
  double gap = 0.0;
  for (const int f : failing)
    gap = std::max(gap, face_planarity(model_.points, model_.face(f)).gap);
  const EngineOutcome outcome =
      newton.run_around(problem_, seeds, std::max(gap, 1e-9), options, field_, progress);
  support_ = problem_.seeks_support ? newton.support() : everything();
  report_.status = outcome.status;
  report_.iterations += outcome.steps;
  report_.factorizations += outcome.factorizations;
  report_.records.insert(report_.records.end(), outcome.records.begin(), outcome.records.end());
}

void Projector::solve_augmented_lagrangian(const Progress& progress) {
  AlmOptions options;
  if (options_.max_iterations > 0) options.max_outer = options_.max_iterations;
  std::vector<int> support;
  const EngineOutcome outcome = solve_edit_by_alm(problem_, options, field_, support, progress);
  support_ = problem_.seeks_support ? support : everything();
  report_.status = outcome.status;
  report_.iterations = outcome.steps;
  report_.factorizations = outcome.factorizations;
  report_.records = outcome.records;
}

ProjectionResult Projector::run(const std::vector<int>& failing, const Progress& progress) {
  const Stopwatch watch;
  if (options_.engine == Engine::kAugmentedLagrangian) {
    solve_augmented_lagrangian(progress);
  } else if (!problem_.seeks_support && problem_.fairness_weight == 0.0) {
    solve_nearest(progress);
  } else {
    solve_newton(failing, progress);
  }
  ExactFinish finish(model_);
  ExactDesign design = finish.finish(problem_, support_, field_, kept_);
  ProjectionResult result;
  result.moved_positions.resize(3, 0);
  result.report = std::move(report_);
  result.report.factorizations += design.factorizations;
  if (!design.positions.allFinite()) {
    result.report.status = SolveStatus::kNonFinite;
    return result;
  }
  PatchCutter cutter(model_.vertex_count(), model_.mesh.face_count(),
                     static_cast<int>(model_.fairness.rows()));
  result.report.objective = design_objective(problem_, design, cutter);
  result.moved = design.vertices;
  result.moved_positions = design.positions;
  result.report.solve_seconds = watch.seconds();
  return result;
}

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

/// How one attempt is made.
enum class Attempt { kNearest, kConfined, kWeighted };

/// Attempts from `current` until no panel fails or the rounds are over. A large correction can make
/// the vertices that carry a panel's plane collinear; the next round chooses them anew.
ProjectionResult attempt(Mesh& current, MeshStanding& standing, Attempt kind, int rings,
                         const Positions* reference, const Adjacency& adjacency,
                         const ProjectionOptions& options, const std::vector<int>& pins,
                         const Progress& progress) {
  ProjectionResult result;
  const KeptKinds kept = kept_kinds(options.tolerance, options.constraints);
  for (int round = 0; round < kRounds && !standing.failing.empty(); ++round) {
    Projector projector(current, options, pins);
    if (kind == Attempt::kWeighted) {
      projector.penalise_unmoved(*reference);
    } else {
      projector.penalise_squares();
    }
    if (kind == Attempt::kConfined) projector.confine(standing.failing, rings);
    ProjectionResult step = projector.run(standing.failing, progress);
    for (std::size_t k = 0; k < step.moved.size(); ++k) {
      current.positions.col(step.moved[k]) = step.moved_positions.col(static_cast<Eigen::Index>(k));
    }
    standing = measure_standing(current, adjacency, kept);
    step.report.iterations += result.report.iterations;
    step.report.factorizations += result.report.factorizations;
    step.report.solve_seconds += result.report.solve_seconds;
    result.report = std::move(step.report);
    if (!result.report.usable()) break;
  }
  return result;
}

/// One projection: what was given, and how flat it was.
struct Task {
  const Mesh& mesh;
  const Positions* reference;  ///< null without a history
  const ProjectionOptions& options;
  const std::vector<int>& pins;
  const KeptKinds& kept;
  const Adjacency& adjacency;  ///< empty unless a kept kind hangs on stars
  MeshStanding before;
};

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

/// Whatever becomes of the panels' shape.
Positions project_freely(const Task& task, const Progress& progress, ProjectionResult& result) {
  Mesh current = task.mesh;
  MeshStanding after = task.before;
  const auto& [mesh, reference, options, pins, kept, adjacency, before] = task;
  const Attempt first = reference != nullptr ? Attempt::kWeighted : Attempt::kNearest;
  result = attempt(current, after, first, 0, reference, adjacency, options, pins, progress);
  // Where the weighted problem does not close, the nearest flat mesh in growing surroundings does,
  // and still leaves the rest alone.
  for (const int rings : {2, 4, 8, 16}) {
    if (after.failing.empty() || reference == nullptr ||
        result.report.status == SolveStatus::kCancelled) {
      break;
    }
    Mesh again = mesh;
    MeshStanding left = before;
    ProjectionResult next = attempt(again, left, Attempt::kConfined, rings, reference, adjacency,
                                    options, pins, progress);
    if (left.failing.size() > after.failing.size()) continue;
    result = std::move(next);
    current = std::move(again);
    after = std::move(left);
  }
  result.fairness_weight = options.fairness_weight;
  conclude(task, current.positions, std::move(after), result);
  return std::move(current.positions);
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

/// With every panel's shape kept, in growing surroundings of the panels that fail. With a history,
/// what does not become flat stays as it is: a variation half made exact is of no use.
ProjectionResult project_within_bounds(const Task& task, const Progress& progress) {
  const auto& [mesh, reference, options, pins, kept, adjacency, before] = task;
  const MeshModel model(mesh, options.fairness);
  const int everything = mesh.vertex_count();
  std::vector<int> last;
  SoundProjection best;
  for (const int rings : {8, 32, reference != nullptr ? 32 : everything}) {
    std::vector<int> free = surroundings(task, model, rings);
    if (free.size() == last.size()) continue;
    SoundProjection next = project_soundly(mesh, reference != nullptr ? *reference : mesh.positions,
                                           options, free, progress);
    const bool cancelled = next.report.status == SolveStatus::kCancelled;
    if (next.is_better_than(best)) best = std::move(next);
    if (cancelled || best.is_flat()) break;
    last = std::move(free);
  }
  ProjectionResult result;
  result.report = std::move(best.report);
  result.fairness_weight = best.fairness_weight;
  const bool useful = reference == nullptr ? best.found() : best.is_flat();
  Mesh after = mesh;
  if (useful) after.positions = std::move(best.positions);
  conclude(task, after.positions, measure_standing(after, adjacency, kept), result);
  return result;
}

ProjectionResult project(const Mesh& mesh, const Positions* reference,
                         const ProjectionOptions& options, const std::vector<int>& pins,
                         const Progress& progress) {
  ProjectionResult result;
  result.moved_positions.resize(3, 0);
  const KeptKinds kept = kept_kinds(options.tolerance, options.constraints);
  const bool stars = kept.has_element(Element::kVertex);
  const Adjacency adjacency = stars ? build_adjacency(mesh) : Adjacency();
  const Task task{
      mesh, reference, options, pins, kept, adjacency, measure_standing(mesh, adjacency, kept)};
  add_violations(kept, task.before.worst, task.before.worst, result.report);
  result.report.status = SolveStatus::kConverged;
  if (task.before.failing.empty()) return result;  // flat already: the same bits
  // Fair meshes seldom need the bound, but the engine that knows it is the faster one as well.
  const bool fair = options.keep_shape && reference == nullptr && options.fairness_weight > 0.0 &&
                    options.engine == Engine::kNewton;
  if (fair) return project_within_bounds(task, progress);
  const Positions after = project_freely(task, progress, result);
  const Positions& shape_before = reference != nullptr ? *reference : mesh.positions;
  if (!options.keep_shape || result.report.status == SolveStatus::kCancelled ||
      spoilt_faces(mesh, shape_before, after).empty()) {
    return result;
  }
  ProjectionResult sound = project_within_bounds(task, progress);
  // A variation must become flat; what that spoils is reported.
  return reference != nullptr && !sound.report.usable() ? result : sound;
}

}  // namespace

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
  if (options.max_iterations < 0) return "max_iterations must be at least 0";
  return std::nullopt;
}

ProjectionResult project_to_planar(const Mesh& mesh, const ProjectionOptions& options,
                                   const std::vector<int>& pins, const Progress& progress) {
  return project(mesh, nullptr, options, pins, progress);
}

ProjectionResult project_to_planar(const Mesh& mesh, const Positions& reference,
                                   const ProjectionOptions& options, const std::vector<int>& pins,
                                   const Progress& progress) {
  return project(mesh, &reference, options, pins, progress);
}

}  // namespace planish
