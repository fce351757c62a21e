// SPDX-License-Identifier: MIT
#include "projection/projector.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "engines/active_set.hpp"
#include "engines/augmented_lagrangian.hpp"
#include "engines/nearest_flat.hpp"
#include "engines/optimality.hpp"
#include "engines/tangent_newton.hpp"
#include "engines/working_set.hpp"
#include "engines/working_set_newton.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/numeric/index.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "planish/problem/mesh_standing.hpp"

namespace planish {

Projector::Projector(const Mesh& mesh, const ProjectionOptions& options,
                     const std::vector<int>& pins)
    : options_(options),
      kept_(kept_kinds(options.tolerance, options.constraints)),
      model_(mesh, options.fairness, kept_),
      field_(model_.vertex_count(), static_cast<int>(model_.equations.size())) {
  problem_.model = &model_;
  problem_.fairness_weight = 2.0 * options.fairness_weight;
  problem_.terms.resize(at(model_.vertex_count()));
  for (const int v : pins) problem_.terms[at(v)].fixed = true;
}

void Projector::penalise_squares() {
  problem_.seeks_support = false;
  for (VertexTerm& term : problem_.terms) term.square_weight = 2.0 * options_.distance_weight;
}

void Projector::penalise_unmoved(const Positions& reference) {
  problem_.seeks_support = true;
  const Positions moved = (model_.mesh.positions - reference) / model_.unit();
  const double largest = moved.cols() > 0 ? moved.colwise().norm().maxCoeff() : 0.0;
  const double soft = std::max(0.05 * largest, 1e-6);
  for (int v = 0; v < model_.vertex_count(); ++v) {
    const double weight = soft / (soft + moved.col(v).norm());
    problem_.terms[at(v)].norm_weight = 2.0 * options_.distance_weight * weight;
  }
}

void Projector::stand_on(const Mesh& base) {
  slides_.emplace(base, model_.mesh.positions, options_.supports, model_.unit());
  slides_->hold(problem_);
}

void Projector::confine(const std::vector<int>& failing, int rings) {
  WorkingSetGrower grower(model_);
  free_ = grower.grow(vertices_of(model_.mesh, failing), rings);
}

std::vector<int> Projector::everything() const {
  std::vector<int> all(at(model_.vertex_count()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void Projector::solve_nearest(const Progress& progress) {
  support_ = free_.empty() ? everything() : free_;
  PatchCutter cutter(model_);
  Patch patch;
  cutter.cut(problem_, support_, patch);
  Eigen::Matrix3Xd displacement = on_tracks(patch);
  EngineOutcome outcome = patch.free_count > kMostFactored
                              ? nearest_of_large(patch, progress, displacement)
                              : nearest_of_small(patch, progress, displacement);
  for (int k = 0; k < patch.free_count; ++k) {
    field_.set_displacement(patch.vertices[at(k)], displacement.col(k));
  }
  report_.status = outcome.status;
  report_.cost = outcome.cost;
  report_.records = std::move(outcome.records);
}

EngineOutcome Projector::nearest_of_small(const Patch& patch, const Progress& progress,
                                          Eigen::Matrix3Xd& displacement) const {
  NearestFlatOptions nearest;
  if (options_.max_iterations > 0) nearest.max_steps = options_.max_iterations;
  // Who asks for fabrication's tolerance only need not wait for the last digits of the distance.
  nearest.settled = std::clamp(0.01 * options_.tolerance, nearest.settled, 1e-3);
  return find_nearest_flat(patch, nearest, progress, displacement);
}

/// Near the flat meshes the Hessian's curvature, which the first iteration leaves out, is what
/// decides: it alone needs hundreds of steps there and ends short of a certificate.
EngineOutcome Projector::nearest_of_large(const Patch& patch, const Progress& progress,
                                          Eigen::Matrix3Xd& displacement) const {
  constexpr int kMostTangentSteps = 200;
  NearestFlatOptions nearest{.settled = 1e-2};
  if (options_.max_iterations > 0) nearest.max_steps = options_.max_iterations;
  EngineOutcome onto = find_nearest_flat(patch, nearest, progress, displacement);
  if (onto.status != SolveStatus::kConverged) return onto;
  TangentNewtonOptions tangent{.max_steps = kMostTangentSteps};
  if (options_.max_iterations > 0) tangent.max_steps = options_.max_iterations - onto.cost.steps;
  EngineOutcome along = descend_along_flat(patch, tangent, progress, displacement);
  along.cost += onto.cost;
  along.records.insert(along.records.begin(), onto.records.begin(), onto.records.end());
  return along;
}

void Projector::solve_newton(const std::vector<int>& failing, const Progress& progress) {
  constexpr int kNewtonLimit = 200;
  WorkingSetNewton newton(model_);
  NewtonOptions options;
  options.max_steps = options_.max_iterations > 0 ? options_.max_iterations : kNewtonLimit;
  const std::vector<int> seeds = vertices_of(model_.mesh, failing);
  double gap = 0.0;
  for (const int f : failing)
    gap = std::max(gap, face_planarity(model_.points, model_.face(f)).gap);
  const EngineOutcome outcome =
      newton.run_around(problem_, seeds, std::max(gap, 1e-9), options, field_, progress);
  support_ = problem_.seeks_support ? newton.support() : everything();
  report_.status = outcome.status;
  report_.cost += outcome.cost;
  report_.records.insert(report_.records.end(), outcome.records.begin(), outcome.records.end());
}

void Projector::solve_weighted(const std::vector<int>& failing, const Progress& progress) {
  weighted_.emplace(model_);
  NearestWeightedOptions options;
  if (options_.max_iterations > 0) options.max_steps = options_.max_iterations;
  EngineOutcome outcome =
      weighted_->run(problem_, vertices_of(model_.mesh, failing), options, progress);
  field_ = weighted_->field();
  support_ = weighted_->support();
  report_.status = outcome.status;
  report_.cost = outcome.cost;
  report_.records = std::move(outcome.records);
}

/// "Converged" means certified on the finished mesh.
void Projector::certify(const ExactDesign& design, PatchCutter& cutter) {
  if (weighted_) {
    report_.optimality = weighted_->optimality(design.vertices, design.displacement);
  } else if (!problem_.seeks_support) {
    Patch patch;
    cutter.cut(problem_, support_, patch);
    report_.optimality = fitted_optimality(patch, displacement_on(patch, design));
  }
  const bool met = !report_.optimality || report_.optimality->met();
  const bool held = !slides_ || slides_->holds(design.vertices, design.displacement);
  if (report_.status == SolveStatus::kConverged && !(met && held)) {
    report_.status = SolveStatus::kIterationLimit;
  }
}

void Projector::solve_augmented_lagrangian(const Progress& progress) {
  AlmOptions options;
  options.executor = options_.executor.get();
  if (options_.max_iterations > 0) options.max_outer = options_.max_iterations;
  std::vector<int> support;
  const EngineOutcome outcome = solve_edit_by_alm(problem_, options, field_, support, progress);
  support_ = problem_.seeks_support ? support : everything();
  report_.status = outcome.status;
  report_.cost = outcome.cost;
  report_.records = outcome.records;
}

void Projector::solve(const std::vector<int>& failing, const Progress& progress) {
  if (options_.engine == Engine::kAugmentedLagrangian) {
    solve_augmented_lagrangian(progress);
  } else if (!problem_.seeks_support && problem_.fairness_weight == 0.0) {
    solve_nearest(progress);
  } else if (problem_.seeks_support) {
    solve_weighted(failing, progress);
  } else {
    solve_newton(failing, progress);
  }
}

/// Solved again for as long as points take other sides of their outlines, or other places on
/// surfaces.
ExactDesign Projector::solve_on_tracks(const std::vector<int>& failing, const Progress& progress) {
  ExactFinish finish(model_);
  const auto solve_once = [&] {
    const SolveCost before = std::exchange(report_, {}).cost;
    field_.clear();
    solve(failing, progress);
    ExactDesign design = finish.finish(problem_, support_, field_, kept_);
    report_.cost += before + design.cost;
    return design;
  };
  ExactDesign design = solve_once();
  solve_until_steady(design, kMostOutlineTurns - 1, solve_once, [&](const ExactDesign& last) {
    return report_.status != SolveStatus::kCancelled && slides_ &&
           slides_->follow(last.vertices, last.displacement);
  });
  return design;
}

ProjectionResult Projector::run(const std::vector<int>& failing, const Progress& progress) {
  const Stopwatch watch;
  const ExactDesign design = solve_on_tracks(failing, progress);
  ProjectionResult result;
  result.moved_positions.resize(3, 0);
  PatchCutter cutter(model_);
  certify(design, cutter);
  result.report = std::move(report_);
  if (!design.positions.allFinite()) {
    result.report.status = SolveStatus::kNonFinite;
    return result;
  }
  result.report.objective = design_objective(problem_, design, cutter);
  result.moved = design.vertices;
  result.moved_positions = design.positions;
  result.report.solve_seconds = watch.seconds();
  return result;
}

}  // namespace planish
