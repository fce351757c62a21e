// SPDX-License-Identifier: MIT
/// The last part of a solve: from a minimum that was found with a coarse norm, on a working set
/// that was guessed, to a first-order point of the problem itself, support included. [OPT-2]
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engines/largest.hpp"
#include "engines/optimality.hpp"
#include "engines/working_set_newton.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kFirst = 1e-4;         ///< first ε, share
constexpr double kLast = 1e-12;         ///< last ε, share
constexpr double kShrink = 1e-2;        ///< between two
constexpr double kAtRest = 100.0;       ///< ε: what moves less follows ε from stage to stage
constexpr double kRestsAtLast = 700.0;  ///< ε: w is 1 to within kStationary, so it may as well rest
constexpr double kMovesAtRimFirst = 30;  ///< ε: what moves further joins the working set
constexpr double kMovesAtRimLater = 10;  ///< ε: what joins it once the first has been followed
constexpr int kLinesAhead = 2;           ///< edges along which it then brings its lines with it
constexpr int kMostLinesAhead = 32;      ///< edges where set after set was too small
constexpr int kShortOnes = 3;            ///< sets that were, before lines are followed further
constexpr double kPenalty = 10.0;        ///< μ ε: the constraints of vertices at rest are stiff
constexpr double kMostPenalty = 1e11;    ///< μ: above it λ is what rounding makes of c
constexpr double kFollowed = 1e-2;       ///< ‖∇L‖ at which a stage ends, solver units
constexpr double kStationary = 5e-7;     ///< ‖∇L‖ at which the last stage ends
constexpr double kNearlyStationary = 1e-5;  ///< ... where steps hardly lower it any more
constexpr double kSlow = 0.5;               ///< share of it that such steps leave
constexpr double kHeld = 10.0;              ///< |c| / ε at which a stage ends
constexpr double kCounted = 1e-6;           ///< of the pull: who moves less counts as at rest
constexpr double kStalled = 1e-8;           ///< |c| that need not fall where no step changes it
constexpr double kLimitsHeld = 1e-7;        ///< share by which a limit that presses may be off
constexpr double kLimitPenalty = 1e3;  ///< μ of the limits: their multipliers are known by then
constexpr double kLateLimitPenalty = 1e4;  ///< once the first ε has been followed
constexpr int kMostRefinements = 6;
constexpr double kExactRows = 1e-13;  ///< |c| that a finish leaves as it is
constexpr int kStepsPerRun = 2;       ///< on one of them
constexpr double kMostWork = 1e6;     ///< points × steps, all runs

}  // namespace

/// The first working set: a small region as a whole; elsewhere the support, and the neighbours of
/// handles that are fixed, whose rows belong to no free vertex of the support; everything where no
/// support is sought.
void WorkingSetNewton::choose_first_working_set(const EditProblem& problem) {
  std::vector<int> fixed;
  std::copy_if(problem.handles.begin(), problem.handles.end(), std::back_inserter(fixed),
               [&](int v) { return problem.terms[at(v)].fixed; });
  working_ = set_union(support_, grower_.grow(fixed, 1));
  if (is_working_set_at_once(problem)) working_ = set_union(working_, problem.region);
  if (seeks_support_) return;
  working_.resize(at(model_.vertex_count()));
  std::iota(working_.begin(), working_.end(), 0);
}

/// The working set and everything that shares a row with it; the state comes from `field`.
void WorkingSetNewton::open_patch(const EditProblem& problem, DisplacementField& field) {
  cutter_.cut_open(problem, working_, patch_);
  system_.attach(patch_);
  step_.attach(system_, patch_.free_count);
  field.load(patch_, state_);
}

/// Free vertices beyond the working set that move by more than `rest`.
std::vector<int> WorkingSetNewton::movers_at_rim(double rest) const {
  std::vector<int> movers;
  for (int k = 0; k < patch_.free_count; ++k) {
    const int v = patch_.vertices[at(k)];
    if (state_.displacement.col(k).norm() <= rest) continue;
    if (!std::binary_search(working_.begin(), working_.end(), v)) movers.push_back(v);
  }
  std::sort(movers.begin(), movers.end());
  return movers;
}

/// What moves joins the working set, with what is ahead along its lines; at the first ε alone, for
/// the basin may not be found. Where set after set is too small, lines run on through the mesh:
/// each set then follows them twice as far as the one before.
void WorkingSetNewton::extend(const std::vector<int>& movers, bool first_stage, int extensions) {
  const int doublings = extensions - kShortOnes;
  int ahead = first_stage ? 0 : kLinesAhead;
  if (doublings > 0) ahead = std::max(ahead, 1 << std::min(doublings, 16));
  ahead = std::min(ahead, kMostLinesAhead);
  working_ = set_union(working_, grower_.with_lines_ahead(movers, working_, ahead));
}

/// What rounding the patch's coordinates leaves of a length.
double WorkingSetNewton::rounding() const {
  constexpr double kUlps = 16.0 * std::numeric_limits<double>::epsilon();
  return kUlps * patch_.points.cwiseAbs().maxCoeff();
}

/// How much the limits are broken, or kept where they press: complementarity.
double WorkingSetNewton::limit_violation() {
  if (!system_.has_limits()) return 0.0;
  system_.lagrangian().shares(state_.displacement, shares_);
  return complementarity(shares_, state_.limit_multipliers);
}

/// Newton's steps at one ε on one working set. True once the gradient is zero and the rows hold.
bool WorkingSetNewton::settle_at(double smoothing, const NewtonOptions& options,
                                 EngineOutcome& outcome) {
  for (int step = 0; step < kStepsPerRun; ++step) {
    system_.lagrangian().residuals(state_.displacement, residuals_);
    system_.lagrangian().gradient_at(state_, smoothing, gradient_);
    const double off = largest_entry(residuals_);
    // Rows among points that cannot move keep what the base has: no step betters them.
    const bool stalled = off <= kStalled && std::abs(off - last_off_) <= 1e-3 * off;
    last_off_ = off;
    if (longest_column(gradient_) <= options.stationary &&
        (off <= std::max(kHeld * smoothing, rounding()) || stalled) &&
        limit_violation() <= std::max(kLimitsHeld, smoothing)) {
      return true;
    }
    PrimalDualStep::Result result = PrimalDualStep::Result::kRejected;
    for (int attempt = 0; attempt < 4 && result == PrimalDualStep::Result::kRejected; ++attempt) {
      result = step_.take(options.step, smoothing, state_);
    }
    ++outcome.cost.steps;
    if (result != PrimalDualStep::Result::kAccepted) return false;
  }
  return false;
}

/// What is at rest follows ε: w = d/√(‖d‖² + ε²) then stays what it is. Where that would take a
/// corner beyond its bound, all stay where they are: a state beyond it has no merit, and the steps
/// from there do not see the bound.
void WorkingSetNewton::shrink_what_rests(double smoothing, double shrink) {
  before_ = state_.displacement;
  for (int k = 0; k < patch_.free_count; ++k) {
    if (patch_.terms[at(k)].norm_weight <= 0.0) continue;
    if (state_.displacement.col(k).norm() <= kAtRest * smoothing) {
      state_.displacement.col(k) *= shrink;
    }
  }
  if (!std::isfinite(system_.lagrangian().energy(state_.displacement, smoothing))) {
    state_.displacement.swap(before_);
  }
}

EngineOutcome WorkingSetNewton::settle(const EditProblem& problem, const NewtonOptions& options,
                                       DisplacementField& field, const Progress& progress) {
  EngineOutcome outcome;
  const int before = system_.factorizations();
  const double scale = handle_scale(problem);
  seeks_support_ = problem.seeks_support;
  NewtonOptions exact = options;
  exact.step.limits_may_stay = false;
  choose_first_working_set(problem);
  double smoothing = seeks_support_ ? kFirst * scale : kLast * scale;
  double work = 0.0;
  double last_slope = std::numeric_limits<double>::infinity();
  int extensions = 0;  // at this ε
  step_.forget_shift();
  open_patch(problem, field);
  settled_ = state_;
  settled_smoothing_ = smoothing;
  if (patch_.free_count == 0 ||
      !std::isfinite(system_.lagrangian().energy(state_.displacement, smoothing))) {
    return outcome;
  }
  last_off_ = 0.0;
  while (outcome.cost.steps < options.max_settle_steps && work < kMostWork) {
    const bool first_stage = smoothing >= kFirst * scale;
    if (first_stage && outcome.cost.steps >= options.max_first_settle_steps) break;
    const bool last = !seeks_support_ || smoothing <= kLast * scale;
    exact.stationary = last ? kStationary : kFollowed;
    exact.step.limit_penalty = first_stage ? kLimitPenalty : kLateLimitPenalty;
    exact.step.penalty = seeks_support_
                             ? std::clamp(kPenalty / smoothing, options.step.penalty, kMostPenalty)
                             : options.step.penalty;
    const int first = outcome.cost.steps;
    const bool done = settle_at(smoothing, exact, outcome);
    work += static_cast<double>((outcome.cost.steps - first) * patch_.free_count);
    field.store(patch_, state_);
    outcome.objective = system_.lagrangian().energy(state_.displacement, 0.0);
    const IterationRecord record{.objective = outcome.objective,
                                 .primal_residual = step_.violation(),
                                 .step = step_.largest_move(),
                                 .smoothing = smoothing};
    if (progress && progress(record) == Flow::kStop) {
      outcome.status = SolveStatus::kCancelled;
      break;
    }
    const std::vector<int> movers =
        movers_at_rim((first_stage ? kMovesAtRimFirst : kMovesAtRimLater) * smoothing);
    if (!movers.empty()) {
      extend(movers, first_stage, ++extensions);
      open_patch(problem, field);
      continue;
    }
    const double slope = longest_column(gradient_);
    const bool slow = slope <= kNearlyStationary && slope > kSlow * last_slope;
    last_slope = slope;
    const bool spent =
        last && (slow || step_.largest_move() <= rounding());  // no step changes anything any more
    if (!done && !spent) continue;
    if (last) {
      outcome.status = SolveStatus::kConverged;
      break;
    }
    const double shrink = std::max(kShrink, kLast * scale / smoothing);
    shrink_what_rests(smoothing, shrink);
    smoothing *= shrink;
    extensions = 0;
    step_.restart();
  }
  keep_settled(smoothing, field);
  outcome.cost.factorizations = system_.factorizations() - before;
  return outcome;
}

EngineOutcome WorkingSetNewton::refine(const EditProblem& problem, const NewtonOptions& options,
                                       DisplacementField& field) {
  EngineOutcome outcome;
  const int before = system_.factorizations();
  StepOptions step = options.step;
  step.limits_may_stay = false;
  step.limit_penalty = kLateLimitPenalty;
  if (problem.seeks_support) step.penalty = std::max(step.penalty, kMostPenalty);
  state_ = settled_;
  keep_support(kRestsAtLast * settled_smoothing_);
  std::vector<Slide> given = patch_.slides;
  hold_what_rests();
  for (; outcome.cost.steps < kMostRefinements; ++outcome.cost.steps) {
    system_.lagrangian().residuals(state_.displacement, residuals_);
    system_.lagrangian().gradient_at(state_, settled_smoothing_, gradient_);
    const double off = largest_entry(residuals_);
    if (off <= kExactRows && longest_column(gradient_) <= kStationary) break;
    if (step_.take(step, settled_smoothing_, state_) != PrimalDualStep::Result::kAccepted) break;
  }
  patch_.slides.swap(given);
  system_.attach(patch_);
  field.store(patch_, state_);
  outcome.cost.factorizations = system_.factorizations() - before;
  return outcome;
}

/// Holds all of the patch but the support.
void WorkingSetNewton::hold_what_rests() {
  std::vector<Slide> slides;
  auto given = patch_.slides.begin();
  for (int k = 0; k < patch_.free_count; ++k) {
    while (given != patch_.slides.end() && given->vertex < k) ++given;
    if (!std::binary_search(support_.begin(), support_.end(), patch_.vertices[at(k)])) {
      slides.push_back({k, {}});
      slides.back().track.along.setZero();
    } else if (given != patch_.slides.end() && given->vertex == k) {
      slides.push_back(*given);
    }
  }
  patch_.slides = std::move(slides);
  system_.attach(patch_);
  step_.attach(system_, patch_.free_count);
}

void WorkingSetNewton::keep_settled(double smoothing, DisplacementField& field) {
  settled_ = state_;
  settled_smoothing_ = smoothing;
  keep_support(kRestsAtLast * smoothing);
  field.store(patch_, state_);
}

/// What is at rest stays exactly there; the rest is the support.
void WorkingSetNewton::keep_support(double rest) {
  support_.clear();
  for (int k = 0; k < patch_.free_count; ++k) {
    const VertexTerm& term = patch_.terms[at(k)];
    const bool rests = seeks_support_ && !term.handle && term.norm_weight > 0.0 &&
                       state_.displacement.col(k).norm() <= rest;
    if (rests) {
      state_.displacement.col(k).setZero();
    } else {
      support_.push_back(patch_.vertices[at(k)]);
    }
  }
  std::sort(support_.begin(), support_.end());
}

void WorkingSetNewton::keep_slow_movers(DisplacementField& field) {
  state_ = settled_;
  keep_support(kAtRest * settled_smoothing_);
  field.store(patch_, state_);
}

std::vector<int> WorkingSetNewton::certified_set() const {
  std::vector<int> set(patch_.vertices.begin(), patch_.vertices.begin() + patch_.free_count);
  std::sort(set.begin(), set.end());
  return set;
}

Optimality WorkingSetNewton::optimality(const EditProblem& problem, std::span<const int> vertices,
                                        const Eigen::Matrix3Xd& displacement) {
  auto missing = std::count_if(vertices.begin(), vertices.end(),
                               [&](int v) { return !problem.terms[at(v)].fixed; });
  for (int k = 0; k < patch_.free_count; ++k) {
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), patch_.vertices[at(k)]);
    const bool moved = found != vertices.end() && *found == patch_.vertices[at(k)];
    state_.displacement.col(k) = moved ? Eigen::Vector3d(displacement.col(found - vertices.begin()))
                                       : Eigen::Vector3d::Zero().eval();
    missing -= moved ? 1 : 0;
  }
  system_.lagrangian().gradient_at(state_, std::numeric_limits<double>::infinity(), gradient_);
  Optimality result =
      optimality_of(patch_, state_.displacement, gradient_, kCounted * handle_scale(problem));
  if (problem.slides != nullptr && problem.slides->has_rests()) {
    judge_rests(problem, kCounted * handle_scale(problem), result);
  }
  if (system_.has_limits()) {
    system_.lagrangian().shares(state_.displacement, shares_);
    shares_.array() += kLimitMargin;  // of the bound as it is stated
    result.complementarity = complementarity(shares_, state_.limit_multipliers);
  }
  // The finish moved what the multipliers know nothing of, or a bound is broken.
  const bool within = std::isfinite(system_.lagrangian().energy(state_.displacement, 0.0));
  if (missing > 0 || !within) result.stationarity = std::numeric_limits<double>::infinity();
  return result;
}

}  // namespace planish
