// SPDX-License-Identifier: MIT
#include "planish/projection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planish/engines/augmented_lagrangian.hpp"
#include "planish/engines/exact_finish.hpp"
#include "planish/engines/nearest_flat.hpp"
#include "planish/engines/working_set_newton.hpp"
#include "planish/index.hpp"
#include "planish/metrics.hpp"
#include "planish/stopwatch.hpp"

namespace planish {
namespace {

constexpr int kNewtonLimit = 100;
constexpr int kRounds = 3;  ///< how often planes may be carried by other vertices

/// How flat a mesh is, measured once per attempt.
struct Flatness {
  double worst = 0.0;        ///< mm/m
  std::vector<int> failing;  ///< faces above the tolerance, worst first
};

Flatness measure_flatness(const Mesh& mesh, double tolerance) {
  Flatness flatness;
  std::vector<std::pair<double, int>> found;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const FacePlanarity face = face_planarity(mesh.positions, mesh.face(f));
    const double gap = face.excess;
    if (!(face.mm_per_m <= flatness.worst)) flatness.worst = face.mm_per_m;
    if (!(gap <= tolerance)) found.emplace_back(-gap, f);
  }
  std::sort(found.begin(), found.end());
  flatness.failing.reserve(found.size());
  for (const auto& [gap, face] : found) flatness.failing.push_back(face);
  return flatness;
}

/// One projection: the problem, the engine that suits it, and the result.
class Projector {
 public:
  Projector(const Mesh& mesh, const ProjectionOptions& options, const std::vector<int>& pins)
      : options_(options),
        model_(mesh, options.fairness),
        field_(model_.vertex_count(), static_cast<int>(model_.equations.size())) {
    problem_.model = &model_;
    problem_.fairness_weight = 2.0 * options.fairness_weight;
    problem_.terms.resize(at(model_.vertex_count()));
    for (const int v : pins) problem_.terms[at(v)].fixed = true;
  }

  /// α_d ‖t̃‖², every vertex free. [PRO-2]
  void penalise_squares() {
    problem_.sparse = false;
    for (VertexTerm& term : problem_.terms) term.square_weight = 2.0 * options_.distance_weight;
  }

  /// α_d Σ w_i ‖t̃_i‖ with w_i = s / (s + ‖p̃_i − p⁰_i‖): 1 where nothing moved yet. [PRO-3]
  void penalise_unmoved(const Positions& reference) {
    problem_.sparse = true;
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
    free_ = grower.grow(vertices_of(failing), rings);
  }

 private:
  [[nodiscard]] std::vector<int> vertices_of(const std::vector<int>& faces) const;
  void solve_nearest(const Progress& progress);
  void solve_newton(const std::vector<int>& failing, const Progress& progress);
  void solve_augmented_lagrangian(const Progress& progress);
  [[nodiscard]] std::vector<int> everything() const {
    std::vector<int> all(at(model_.vertex_count()));
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  ProjectionOptions options_;
  MeshModel model_;
  EditProblem problem_;
  DisplacementField field_;
  std::vector<int> free_;  ///< empty: every vertex
  std::vector<int> support_;
  SolveReport report_;
};

std::vector<int> Projector::vertices_of(const std::vector<int>& faces) const {
  std::vector<int> vertices;
  for (const int f : faces) {
    const auto face = model_.face(f);
    vertices.insert(vertices.end(), face.begin(), face.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

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
  NearestFlatOutcome outcome = find_nearest_flat(patch, nearest, progress, displacement);
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
  const Interruption interrupted = [&](const IterationRecord& record) {
    return progress && progress(record) == Flow::kStop;
  };
  const std::vector<int> seeds = vertices_of(failing);
  double gap = 0.0;
  for (const int f : failing)
    gap = std::max(gap, face_planarity(model_.points, model_.face(f)).gap);
  const NewtonOutcome outcome =
      newton.run_around(problem_, seeds, std::max(gap, 1e-9), options, field_, interrupted);
  support_ = problem_.sparse ? newton.support() : everything();
  report_.status = outcome.status;
  report_.iterations += outcome.steps;
  report_.factorizations += outcome.factorizations;
  report_.records.insert(report_.records.end(), outcome.records.begin(), outcome.records.end());
}

void Projector::solve_augmented_lagrangian(const Progress& progress) {
  AlmOptions options;
  if (options_.max_iterations > 0) options.max_outer = options_.max_iterations;
  const AlmOutcome outcome = solve_edit_by_alm(problem_, options, field_, progress);
  support_ = problem_.sparse ? outcome.support : everything();
  report_.status = outcome.status;
  report_.iterations = outcome.inner_steps;
  report_.factorizations = outcome.factorizations;
  report_.records = outcome.records;
}

ProjectionResult Projector::run(const std::vector<int>& failing, const Progress& progress) {
  const Stopwatch watch;
  if (options_.engine == Engine::kAugmentedLagrangian) {
    solve_augmented_lagrangian(progress);
  } else if (!problem_.sparse && problem_.fairness_weight == 0.0) {
    solve_nearest(progress);
  } else {
    solve_newton(failing, progress);
  }
  ExactFinish finish(model_);
  ExactDesign design = finish.finish(problem_, support_, field_, options_.tolerance);
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

/// How one attempt is made.
enum class Attempt { kNearest, kConfined, kWeighted };

/// Attempts from `current` until no panel fails or the rounds are over. A large correction can make
/// the vertices that carry a panel's plane collinear; the next round chooses them anew.
ProjectionResult attempt(Mesh& current, Flatness& flatness, Attempt kind, int rings,
                         const Positions* reference, const ProjectionOptions& options,
                         const std::vector<int>& pins, const Progress& progress) {
  ProjectionResult result;
  for (int round = 0; round < kRounds && !flatness.failing.empty(); ++round) {
    Projector projector(current, options, pins);
    if (kind == Attempt::kWeighted) {
      projector.penalise_unmoved(*reference);
    } else {
      projector.penalise_squares();
    }
    if (kind == Attempt::kConfined) projector.confine(flatness.failing, rings);
    ProjectionResult step = projector.run(flatness.failing, progress);
    for (std::size_t k = 0; k < step.moved.size(); ++k) {
      current.positions.col(step.moved[k]) = step.moved_positions.col(static_cast<Eigen::Index>(k));
    }
    flatness = measure_flatness(current, options.tolerance);
    step.report.iterations += result.report.iterations;
    step.report.factorizations += result.report.factorizations;
    step.report.solve_seconds += result.report.solve_seconds;
    result.report = std::move(step.report);
    if (!result.report.usable()) break;
  }
  return result;
}

ProjectionResult project(const Mesh& mesh, const Positions* reference,
                         const ProjectionOptions& options, const std::vector<int>& pins,
                         const Progress& progress) {
  ProjectionResult result;
  result.moved_positions.resize(3, 0);
  const Flatness before = measure_flatness(mesh, options.tolerance);
  result.report.planarity_before = before.worst;
  result.report.planarity_after = before.worst;
  result.report.status = SolveStatus::kConverged;
  if (before.failing.empty()) return result;  // flat already: the same bits
  Mesh current = mesh;
  Flatness after = before;
  const Attempt first = reference != nullptr ? Attempt::kWeighted : Attempt::kNearest;
  result = attempt(current, after, first, 0, reference, options, pins, progress);
  // Where the weighted problem does not close, the nearest flat mesh in growing surroundings does,
  // and still leaves the rest alone.
  for (const int rings : {2, 4, 8, 16}) {
    if (after.failing.empty() || reference == nullptr ||
        result.report.status == SolveStatus::kCancelled) {
      break;
    }
    Mesh again = mesh;
    Flatness left = before;
    ProjectionResult next =
        attempt(again, left, Attempt::kConfined, rings, reference, options, pins, progress);
    if (left.failing.size() > after.failing.size()) continue;
    result = std::move(next);
    current = std::move(again);
    after = std::move(left);
  }
  record_moves(mesh, current.positions, result);
  result.report.planarity_before = before.worst;
  result.report.planarity_after = after.worst;
  result.failing_faces = std::move(after.failing);
  if (!result.failing_faces.empty() && result.report.usable()) {
    result.report.status = SolveStatus::kToleranceNotMet;
  } else if (result.failing_faces.empty() && result.report.status == SolveStatus::kSingularSystem) {
    result.report.status = SolveStatus::kIterationLimit;
  }
  return result;
}

}  // namespace

std::optional<std::string> find_problem(const ProjectionOptions& options) {
  const auto weight = [](double value) { return std::isfinite(value) && value >= 0.0; };
  if (!weight(options.fairness_weight)) return "fairness_weight must be a number of at least 0";
  if (!weight(options.distance_weight) || options.distance_weight == 0.0) {
    return "distance_weight must be a number greater than 0";
  }
  if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance)) {
    return "tolerance must be a number greater than 0 (mm/m)";
  }
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
