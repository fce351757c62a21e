// SPDX-License-Identifier: MIT
#include "engines/working_set_newton.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// A region of no more vertices is the working set at once: nearly all of it moves in the end, and
/// every set on the way there would have to be cut and analysed anew.
constexpr std::size_t kWholeRegion = 400;
constexpr double kSlowProgress = 1e-4;  ///< relative change per step at which a smoothing is spent
constexpr double kDualActive = 0.9;     ///< ‖w‖ above which a vertex counts as moving

}  // namespace

double handle_scale(const EditProblem& problem) {
  double scale = 0.0;
  for (const int v : problem.handles) scale = std::max(scale, problem.terms[at(v)].target.norm());
  return scale;
}

WorkingSetNewton::WorkingSetNewton(const MeshModel& model)
    : model_(model), cutter_(model), grower_(model) {}

void WorkingSetNewton::set_start(const EditProblem& problem, const StartSet& start) {
  const std::vector<int>& handles = problem.handles;
  start_ = grower_.grow(handles, std::max(start.rings, model_.kept.start_rings()));
  std::vector<int> lines;
  for (const int v : handles) {
    const std::vector<int> through = grower_.lines_through(v, start.line_length);
    lines.insert(lines.end(), through.begin(), through.end());
  }
  start_ = set_union(start_, grower_.grow(lines, 1));
}

EngineOutcome WorkingSetNewton::run_cold(const EditProblem& problem, const StartSet& start,
                                         const NewtonOptions& options, DisplacementField& field,
                                         const Progress& progress) {
  support_ = problem.handles;
  set_start(problem, start);
  NewtonOptions cold = options;
  cold.first_smoothing = start.first_smoothing;
  return run(problem, handle_scale(problem), cold, field, progress);
}

EngineOutcome WorkingSetNewton::run_on(const EditProblem& problem, const StartSet& start,
                                       const NewtonOptions& options, DisplacementField& field,
                                       const Progress& progress) {
  set_start(problem, start);
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

bool WorkingSetNewton::is_working_set_at_once(const EditProblem& problem) {
  return !problem.region.empty() && problem.region.size() <= kWholeRegion;
}

void WorkingSetNewton::choose_working_set(const EditProblem& problem, const NewtonOptions& options,
                                          double relative_smoothing, DisplacementField& field) {
  std::vector<int> next;
  if (is_working_set_at_once(problem) || (!seeks_support_ && !problem.region.empty())) {
    next = problem.region;
  } else if (!seeks_support_) {
    next.resize(at(model_.vertex_count()));
    std::iota(next.begin(), next.end(), 0);
  } else {
    next = grower_.grow(support_, options.rings);
    if (relative_smoothing > options.keep_start) next = set_union(next, start_);
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
  step_.attach(system_, patch_.free_count);
  field.load(patch_, state_);
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
  step_.forget_shift();
  working_.clear();
  std::vector<int> fixed_seeds;
  for (const int v : problem.handles) {
    if (problem.terms[at(v)].fixed) fixed_seeds.push_back(v);
  }
  double objective = 0.0;
  for (; outcome.cost.steps < options.max_steps; ++outcome.cost.steps) {
    choose_working_set(problem, options, smoothing / scale, field);
    if (patch_.free_count == 0) break;
    const PrimalDualStep::Result result = step_.take(options.step, smoothing, state_);
    if (result == PrimalDualStep::Result::kBroken) {
      outcome.status = SolveStatus::kSingularSystem;
      break;
    }
    if (result == PrimalDualStep::Result::kRejected) continue;
    field.store(patch_, state_);
    find_support(smoothing);
    for (const int v : fixed_seeds) {
      const auto place = std::lower_bound(support_.begin(), support_.end(), v);
      if (place == support_.end() || *place != v) support_.insert(place, v);
    }
    const double previous = objective;
    objective = system_.lagrangian().energy(state_.displacement, 0.0);
    outcome.records.push_back({.objective = objective,
                               .primal_residual = step_.violation(),
                               .step = step_.largest_move(),
                               .smoothing = smoothing});
    if (progress && progress(outcome.records.back()) == Flow::kStop) {
      outcome.status = SolveStatus::kCancelled;
      break;
    }
    const double change = std::abs(objective - previous);
    if (smoothing > last) {
      // A new smoothing once the last one has been followed closely enough: lowering it too fast
      // lands in worse minima, staying too long only costs time.
      const bool close =
          step_.is_plain() && step_.largest_move() < 0.5 * std::sqrt(smoothing * scale);
      if (close || change <= kSlowProgress * objective) {
        smoothing = std::max(last, options.smoothing_shrink * smoothing);
        step_.restart();
      }
    } else if (change <= options.stop * objective ||
               step_.largest_move() <= options.settled_move * scale) {
      outcome.status = SolveStatus::kConverged;
      ++outcome.cost.steps;
      break;
    }
  }
  outcome.objective = objective;
  outcome.cost.factorizations = system_.factorizations() - before;
  return outcome;
}

}  // namespace planish
