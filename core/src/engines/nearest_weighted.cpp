// SPDX-License-Identifier: MIT
#include "engines/nearest_weighted.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engines/largest.hpp"
#include "engines/optimality.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Figures of the iteration; ε in units of scale_.
struct NearestWeightedTuning {
  static constexpr int kRings = 16;             ///< around what fails, at first
  static constexpr double kLeastScale = 1e-6;   ///< mean edges
  static constexpr double kFine = 1e-4;         ///< ε from which on what rests follows ε
  static constexpr double kLast = 1e-12;        ///< last ε
  static constexpr double kCoarseShrink = 0.2;  ///< of ε down to kFine
  static constexpr double kFineShrink = 0.1;    ///< of ε from there on
  static constexpr double kAtRest = 100.0;      ///< times ε: what moves less is at rest
  static constexpr double kPenalty = 1e4;       ///< μ ε: far stiffer than norms at rest
  static constexpr double kFirstPenalty = 1e6;  ///< μ at least
  static constexpr double kLastPenalty = 1e13;  ///< μ at most: beyond it rounding is all there is
  static constexpr double kFollowed = 1e-6;  ///< ‖∇L‖ over the largest w/2 that ends a stage
  static constexpr double kStationary = 5e-7;  ///< ‖∇L‖ so scaled that ends the last one
  static constexpr double kCounted = 1e-6;     ///< of the longest move: less counts as at rest
  static constexpr int kStepsPerSet = 60;      ///< at one ε on one working set
  static constexpr int kLastSteps = 30;        ///< at the last ε
  static constexpr double kFlat = 1e-5;        ///< residual that the exact finish takes to rounding
};

using Tuning = NearestWeightedTuning;

/// Who moves less counts as at rest.
double rest_of(const Eigen::Matrix3Xd& t) { return Tuning::kCounted * longest_column(t); }

}  // namespace

NearestWeighted::NearestWeighted(const MeshModel& model)
    : cutter_(model),
      grower_(model),
      field_(model.vertex_count(), static_cast<int>(model.equations.size())),
      newton_(PatchNewton::Factors::kFresh) {}

/// The working set and everything that shares a row with it; the state comes from the field.
void NearestWeighted::open_patch(const EditProblem& problem) {
  cutter_.cut_open(problem, working_, patch_);
  PatchState state;
  field_.load(patch_, state);
  newton_.attach(patch_, std::move(state));
}

/// Newton's steps at one ε on one working set. True once the gradient is zero.
bool NearestWeighted::solve_at(double smoothing, double stationary, int most_steps,
                               const Progress& progress, EngineOutcome& outcome) {
  newton_.set_smoothing(smoothing);
  newton_.set_penalty(
      std::clamp(Tuning::kPenalty / smoothing, Tuning::kFirstPenalty, Tuning::kLastPenalty));
  for (int step = 0; step < most_steps; ++step) {
    // At least one: what was scaled is off the constraints by as much.
    if (step > 0 && newton_.gradient_norm() <= stationary) return true;
    ++outcome.cost.steps;
    if (!newton_.step()) return false;
    outcome.records.push_back({.objective = newton_.objective(),
                               .primal_residual = newton_.violation(),
                               .step = newton_.length(),
                               .smoothing = smoothing});
    if (progress && progress(outcome.records.back()) == Flow::kStop) {
      outcome.status = SolveStatus::kCancelled;
      return false;
    }
  }
  return false;
}

/// Free vertices beyond the working set that do not stay at rest.
std::vector<int> NearestWeighted::movers_at_rim(double smoothing) const {
  std::vector<int> movers;
  const Eigen::Matrix3Xd& t = newton_.state().displacement;
  for (int k = 0; k < patch_.free_count; ++k) {
    const int v = patch_.vertices[at(k)];
    if (t.col(k).norm() <= Tuning::kAtRest * smoothing) continue;
    if (!std::binary_search(working_.begin(), working_.end(), v)) movers.push_back(v);
  }
  std::sort(movers.begin(), movers.end());
  return movers;
}

/// What rests follows ε: t/√(‖t‖² + ε²) then stays what it is.
void NearestWeighted::scale_what_rests(double smoothing, double factor) {
  PatchState state = newton_.state();
  for (int k = 0; k < patch_.free_count; ++k) {
    if (state.displacement.col(k).norm() <= Tuning::kAtRest * smoothing) {
      state.displacement.col(k) *= factor;
    }
  }
  newton_.set_state(std::move(state));
}

/// Takes movers at the rim into the working set; false where there are none.
bool NearestWeighted::add_movers(const EditProblem& problem, double smoothing) {
  const std::vector<int> movers = movers_at_rim(smoothing);
  if (movers.empty()) return false;
  working_ = set_union(working_, movers);
  open_patch(problem);
  return true;
}

/// Down to the last ε that rounding lets settle. False where the steps run out or it is stopped.
bool NearestWeighted::follow(const EditProblem& problem, int most_steps, const Progress& progress,
                             double& smoothing, EngineOutcome& outcome) {
  struct Settled {
    double smoothing;
    PatchState state;
  };
  std::optional<Settled> before;  // on the same working set
  const double last = Tuning::kLast * scale_;
  while (outcome.cost.steps < most_steps) {
    const bool is_last = smoothing <= last;
    const double stationary = is_last ? Tuning::kStationary : Tuning::kFollowed;
    const int steps = std::min(is_last ? Tuning::kLastSteps : Tuning::kStepsPerSet,
                               most_steps - outcome.cost.steps);
    const bool settled =
        solve_at(smoothing, stationary * largest_pull(patch_), steps, progress, outcome);
    field_.store(patch_, newton_.state());
    if (outcome.status == SolveStatus::kCancelled) return false;
    if (add_movers(problem, smoothing)) {
      before.reset();
      continue;
    }
    const bool fine = smoothing <= Tuning::kFine * scale_;
    if (fine && !settled && before) {  // rounding ends it: what settled last stands
      smoothing = before->smoothing;
      newton_.set_state(std::move(before->state));
      field_.store(patch_, newton_.state());
    }
    if (is_last || (fine && !settled)) return true;  // the certificate is measured
    if (settled) before = Settled{smoothing, newton_.state()};
    const double factor =
        std::max(fine ? Tuning::kFineShrink : Tuning::kCoarseShrink, last / smoothing);
    if (fine) scale_what_rests(smoothing, factor);
    smoothing *= factor;
  }
  return false;
}

EngineOutcome NearestWeighted::run(const EditProblem& problem, std::span<const int> seeds,
                                   const NearestWeightedOptions& options,
                                   const Progress& progress) {
  EngineOutcome outcome;
  working_ = grower_.grow(seeds, Tuning::kRings);
  field_.clear();
  open_patch(problem);
  if (patch_.free_count == 0) return outcome;
  scale_ = std::max(newton_.violation(), Tuning::kLeastScale);
  double smoothing = scale_;
  const bool done = follow(problem, options.max_steps, progress, smoothing, outcome);
  if (done && newton_.violation() <= Tuning::kFlat) outcome.status = SolveStatus::kConverged;
  outcome.objective = newton_.objective();
  keep_support(smoothing);
  outcome.cost.factorizations = newton_.factorizations();
  return outcome;
}

/// What is at rest stays exactly there; the rest is the support.
void NearestWeighted::keep_support(double smoothing) {
  support_.clear();
  const Eigen::Matrix3Xd& t = newton_.state().displacement;
  for (int k = 0; k < patch_.free_count; ++k) {
    const int v = patch_.vertices[at(k)];
    if (t.col(k).norm() <= Tuning::kAtRest * smoothing) {
      field_.reset_vertex(v);
    } else {
      field_.set_displacement(v, t.col(k));
      support_.push_back(v);
    }
  }
  std::sort(support_.begin(), support_.end());
}

Optimality NearestWeighted::optimality(std::span<const int> vertices,
                                       const Eigen::Matrix3Xd& displacement) const {
  Eigen::Matrix3Xd t = Eigen::Matrix3Xd::Zero(3, patch_.free_count);
  std::ptrdiff_t missing = std::ssize(vertices);
  for (int k = 0; k < patch_.free_count; ++k) {
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), patch_.vertices[at(k)]);
    if (found == vertices.end() || *found != patch_.vertices[at(k)]) continue;
    t.col(k) = displacement.col(found - vertices.begin());
    --missing;
  }
  Eigen::Matrix3Xd pulls;
  newton_.pulls(t, pulls);
  Optimality result = optimality_of(patch_, t, pulls, rest_of(t));
  // The finish moved what the multipliers know nothing of.
  if (missing > 0) result.stationarity = std::numeric_limits<double>::infinity();
  return result;
}

}  // namespace planish
