// SPDX-License-Identifier: MIT
#include "engines/working_set_newton.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kFirstShift = 1e-2;    ///< first ν tried when the system is not positive definite
constexpr double kLargestShift = 1e6;   ///< beyond it the step is shorter than any progress
constexpr double kSlowProgress = 1e-4;  ///< relative change per step at which a smoothing is spent
constexpr double kDualActive = 0.9;     ///< ‖w‖ above which a vertex counts as moving

}  // namespace

double handle_scale(const EditProblem& problem) {
  double scale = 0.0;
  for (const int v : problem.handles) scale = std::max(scale, problem.terms[at(v)].target.norm());
  return scale;
}

WorkingSetNewton::WorkingSetNewton(const MeshModel& model)
    : model_(model),
      cutter_(model.vertex_count(), model.mesh.face_count(),
              static_cast<int>(model.fairness.rows())),
      grower_(model) {}

void WorkingSetNewton::lay_out(const EditProblem& problem, const StartSet& start) {
  const std::vector<int>& handles = problem.handles;
  start_ = grower_.grow(handles, std::max(start.rings, model_.kept.start_rings()));
  std::vector<int> lines;
  for (const int v : handles) {
    const std::vector<int> through = grower_.lines_through(v, start.line_length);
    lines.insert(lines.end(), through.begin(), through.end());
  }
  const std::vector<int> band = grower_.grow(lines, 1);
  std::vector<int> joined;
  std::set_union(start_.begin(), start_.end(), band.begin(), band.end(),
                 std::back_inserter(joined));
  start_ = std::move(joined);
}

EngineOutcome WorkingSetNewton::run_cold(const EditProblem& problem, const StartSet& start,
                                         const NewtonOptions& options, DisplacementField& field,
                                         const Progress& progress) {
  support_ = problem.handles;
  lay_out(problem, start);
  NewtonOptions cold = options;
  cold.first_smoothing = start.first_smoothing;
  return run(problem, handle_scale(problem), cold, field, progress);
}

EngineOutcome WorkingSetNewton::run_on(const EditProblem& problem, const StartSet& start,
                                       const NewtonOptions& options, DisplacementField& field,
                                       const Progress& progress) {
  lay_out(problem, start);
  return run(problem, handle_scale(problem), options, field, progress);
}

EngineOutcome WorkingSetNewton::run_warm(const EditProblem& problem, const NewtonOptions& options,
                                         DisplacementField& field, const Progress& progress) {
  std::vector<int> joined = problem.handles;
  joined.insert(joined.end(), support_.begin(), support_.end());
  std::sort(joined.begin(), joined.end());
  joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
  support_ = std::move(joined);
  start_.clear();
  return run(problem, handle_scale(problem), options, field, progress);
}

EngineOutcome WorkingSetNewton::run_around(const EditProblem& problem, std::span<const int> seeds,
                                           double scale, const NewtonOptions& options,
                                           DisplacementField& field, const Progress& progress) {
  support_.assign(seeds.begin(), seeds.end());
  std::sort(support_.begin(), support_.end());
  start_ = support_;
  return run(problem, scale, options, field, progress);
}

void WorkingSetNewton::choose_working_set(const EditProblem& problem, const NewtonOptions& options,
                                          double relative_smoothing, DisplacementField& field) {
  std::vector<int> next;
  if (!seeks_support_ && !problem.region.empty()) {
    next = problem.region;
  } else if (!seeks_support_) {
    next.resize(at(model_.vertex_count()));
    std::iota(next.begin(), next.end(), 0);
  } else {
    next = grower_.grow(support_, options.rings);
    if (relative_smoothing > options.keep_start && !start_.empty()) {
      std::vector<int> joined;
      std::set_union(next.begin(), next.end(), start_.begin(), start_.end(),
                     std::back_inserter(joined));
      next = std::move(joined);
    }
  }
  // A set that still holds the support with its rings, and not much more, need not be cut again.
  constexpr double kSlack = 1.05;
  const bool roomy =
      static_cast<double>(working_.size()) <= kSlack * static_cast<double>(next.size());
  if (!working_.empty() && roomy &&
      std::includes(working_.begin(), working_.end(), next.begin(), next.end())) {
    return;
  }
  // What an earlier run or set touched and this one does not hold is exactly zero from here on.
  std::vector<int> before = working_.empty() ? field.touched_vertices() : working_;
  std::sort(before.begin(), before.end());
  std::vector<int> left;
  std::set_difference(before.begin(), before.end(), next.begin(), next.end(),
                      std::back_inserter(left));
  for (const int v : left) field.reset_vertex(v);
  working_ = std::move(next);
  cutter_.cut(problem, working_, patch_);
  system_.attach(patch_);
  field.load(patch_, state_);
  zero_.setZero(3, patch_.free_count);
}

/// Backtracks on the augmented Lagrangian F + λ⁺ᵀc + ρ/2 ‖c‖², each trial corrected to second order
/// with the same factor.
bool WorkingSetNewton::search_line(const NewtonOptions& options, double smoothing,
                                   double decrease) {
  constexpr int kMostHalvings = 10;
  constexpr double kArmijo = 1e-4;
  constexpr double kRounding = 1e-11;
  const auto merit_of = [&](const Eigen::Matrix3Xd& d, const Eigen::VectorXd& c) {
    return system_.lagrangian().energy(d, smoothing) + new_multipliers_.dot(c) +
           0.5 * options.merit_penalty * c.squaredNorm();
  };
  const double start = merit_of(state_.displacement, residuals_);
  const double longest = delta_.colwise().norm().maxCoeff();
  if (!std::isfinite(longest)) return false;
  double length = std::min(1.0, options.trust / std::max(longest, 1e-300));
  for (int halving = 0; halving < kMostHalvings; ++halving, length *= 0.5) {
    trial_ = state_.displacement + length * delta_;
    system_.lagrangian().residuals(trial_, trial_residuals_);
    double merit = merit_of(trial_, trial_residuals_);
    remainder_ = trial_residuals_ - (1.0 - length) * residuals_;
    system_.step(zero_, remainder_, correction_);
    correction_ += trial_;
    system_.lagrangian().residuals(correction_, linear_);
    const double corrected = merit_of(correction_, linear_);
    if (corrected < merit || linear_.squaredNorm() < 1e-2 * trial_residuals_.squaredNorm()) {
      merit = corrected;
      trial_.swap(correction_);
      trial_residuals_.swap(linear_);
    }
    if (merit <= start - kArmijo * length * decrease + kRounding * std::abs(start)) {
      step_length_ = length;
      return true;
    }
  }
  return false;
}

WorkingSetNewton::StepResult WorkingSetNewton::take_step(const NewtonOptions& options,
                                                         double smoothing) {
  system_.lagrangian().residuals(state_.displacement, residuals_);
  system_.lagrangian().gradient_at(state_, smoothing, gradient_);
  while (!system_.factorize(state_, smoothing, options.penalty, shift_)) {
    shift_ = std::max(4.0 * shift_, kFirstShift);
    if (!(shift_ < kLargestShift)) return StepResult::kBroken;
  }
  system_.step(gradient_, residuals_, delta_);
  system_.apply_jacobian(delta_, linear_);
  new_multipliers_ = state_.multipliers + options.penalty * (residuals_ + linear_);
  // Directional derivative of the merit: ∇F·δ + λ⁺ᵀJδ + ρ cᵀJδ.
  const double decrease = -(gradient_.cwiseProduct(delta_).sum() +
                            (new_multipliers_ - state_.multipliers).dot(linear_) +
                            options.merit_penalty * residuals_.dot(linear_));
  if (!search_line(options, smoothing, decrease)) {
    shift_ = std::max(10.0 * shift_, kFirstShift);
    return shift_ < kLargestShift ? StepResult::kRejected : StepResult::kBroken;
  }
  largest_move_ = (trial_ - state_.displacement).colwise().norm().maxCoeff();
  state_.displacement.swap(trial_);  // trial_ is the state before the step from here on
  state_.multipliers += step_length_ * (new_multipliers_ - state_.multipliers);
  update_norm_duals(trial_, smoothing, state_);
  if (step_length_ == 1.0 && shift_ > 0.0) shift_ = shift_ < 1e-3 ? 0.0 : 0.2 * shift_;
  return StepResult::kAccepted;
}

double WorkingSetNewton::violation() const {
  return trial_residuals_.size() > 0 ? trial_residuals_.cwiseAbs().maxCoeff() : 0.0;
}

void WorkingSetNewton::find_support(double smoothing) {
  support_.clear();
  for (int k = 0; k < patch_.free_count; ++k) {
    const bool moving = !seeks_support_ || patch_.terms[at(k)].handle ||
                        state_.displacement.col(k).norm() > 2.0 * smoothing ||
                        state_.norm_dual.col(k).norm() > kDualActive;
    if (moving) support_.push_back(patch_.vertices[at(k)]);
  }
  std::sort(support_.begin(), support_.end());
}

EngineOutcome WorkingSetNewton::run(const EditProblem& problem, double scale,
                                    const NewtonOptions& options, DisplacementField& field,
                                    const Progress& progress) {
  EngineOutcome outcome;
  const int before = system_.factorizations();
  seeks_support_ = problem.seeks_support;
  double smoothing = options.first_smoothing * scale;
  const double last = options.last_smoothing * scale;
  if (!seeks_support_) smoothing = last;
  shift_ = 0.0;
  working_.clear();
  std::vector<int> fixed_seeds;
  for (const int v : problem.handles) {
    if (problem.terms[at(v)].fixed) fixed_seeds.push_back(v);
  }
  double objective = 0.0;
  for (; outcome.steps < options.max_steps; ++outcome.steps) {
    choose_working_set(problem, options, smoothing / scale, field);
    if (patch_.free_count == 0) break;
    const StepResult result = take_step(options, smoothing);
    if (result == StepResult::kBroken) {
      outcome.status = SolveStatus::kSingularSystem;
      break;
    }
    if (result == StepResult::kRejected) continue;
    field.store(patch_, state_);
    find_support(smoothing);
    for (const int v : fixed_seeds) {
      const auto place = std::lower_bound(support_.begin(), support_.end(), v);
      if (place == support_.end() || *place != v) support_.insert(place, v);
    }
    const double previous = objective;
    objective = system_.lagrangian().energy(state_.displacement, 0.0);
    outcome.records.push_back({.objective = objective,
                               .primal_residual = violation(),
                               .step = largest_move_,
                               .smoothing = smoothing});
    if (progress && progress(outcome.records.back()) == Flow::kStop) {
      outcome.status = SolveStatus::kCancelled;
      break;
    }
    const double change = std::abs(objective - previous);
    const bool free_step = step_length_ == 1.0 && shift_ == 0.0;
    if (smoothing > last) {
      // A new smoothing once the last one has been followed closely enough: lowering it too fast
      // lands in worse minima, staying too long only costs time.
      const bool close = free_step && largest_move_ < 0.5 * std::sqrt(smoothing * scale);
      if (close || change <= kSlowProgress * objective) {
        smoothing = std::max(last, options.smoothing_shrink * smoothing);
      }
    } else if (change <= options.stop * objective ||
               largest_move_ <= options.settled_move * scale) {
      outcome.status = SolveStatus::kConverged;
      ++outcome.steps;
      break;
    }
  }
  outcome.objective = objective;
  outcome.factorizations = system_.factorizations() - before;
  return outcome;
}

}  // namespace planish
