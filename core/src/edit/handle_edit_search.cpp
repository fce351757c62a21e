// SPDX-License-Identifier: MIT
/// From the targets to a certified design.
#include <algorithm>
#include <utility>

#include "edit/edit_reach.hpp"
#include "edit/handle_edit_state.hpp"
#include "edit/softness.hpp"
#include "engines/augmented_lagrangian.hpp"
#include "engines/cold_search.hpp"
#include "planish/constraints/mesh_keep_outs.hpp"

namespace planish {
namespace {

constexpr double kCoarse = 0.0045;  ///< smoothing that a search within a reach ends at, share

// What takes more ends no lower; where many stated limits act, late steps still pay.
constexpr SearchBudget kPlain{40, 60, 25, 80, 25, 150};
constexpr SearchBudget kLimited{80, 120, 60, 150, 40, 300};

}  // namespace

/// Within a reach the problem is small and steep, its multipliers are large; elsewhere the engine's
/// own tuning stands.
NewtonOptions HandleEditSolver::State::engine_options() const {
  NewtonOptions options;
  if (follows_softness()) {
    options.step.penalty = 1e8;
    options.step.poor_share = 0.3;
    options.max_first_settle_steps = budget().first_settle;
    options.max_settle_steps = budget().settle;
  }
  if (options_.max_iterations > 0) options.max_steps = options_.max_iterations;
  return options;
}

bool HandleEditSolver::State::follows_softness() const {
  return options_.softness > 0.0 && has_reach(options_);
}

const SearchBudget& HandleEditSolver::State::budget() const {
  return options_.bounds.empty() ? kPlain : kLimited;
}

/// Search, then down to where the limits are, then the certificate.
ExactDesign HandleEditSolver::State::solve_newton(const Progress& progress, SolveReport& report) {
  const NewtonOptions options = engine_options();
  EngineOutcome outcome = targets_.continuation > 0 ? continue_from_base(options, progress)
                          : follows_softness()
                              ? soften(options, progress)
                              : find_minimum(problem_, options, *newton_, *trial_, progress);
  report.status = outcome.status;
  report.cost += outcome.cost;
  report.records = std::move(outcome.records);
  choose_sides(options, progress, report);
  const bool limited =
      !options_.bounds.empty() || (has_keep_outs() && limits_->keep_outs()->has_rows());
  if (limited) {
    if (auto design = settle_at_limits(options, progress, report)) return std::move(*design);
  }
  return settle(options, progress, report);
}

/// Whether points on an outline take another side of it than the one they were solved on [SUP-3],
/// or a keep-out is met that was not.
bool HandleEditSolver::State::turns(const ExactDesign& design) {
  const bool met = has_keep_outs() && meets_keep_outs(design);
  return (slides_ != nullptr && slides_->follow(design.vertices, design.displacement)) || met;
}

/// Which side of its outline each point goes to, and which points keep-outs hold, before anything
/// is settled. [SUP-3] [KEE-2]
void HandleEditSolver::State::choose_sides(const NewtonOptions& options, const Progress& progress,
                                           SolveReport& report) {
  const bool turning = slides_ != nullptr && slides_->has_turning_tracks();
  if (!turning && !(has_keep_outs() && keep_outs_turn())) return;
  NewtonOptions step = options;
  step.first_smoothing = 1e-3;
  for (int round = 0; round < kMostOutlineTurns && report.status != SolveStatus::kCancelled;
       ++round) {
    if (!turns(finish_->finish(problem_, newton_->support(), *trial_, kept_))) return;
    const EngineOutcome way = newton_->run_warm(problem_, step, *trial_, progress);
    report.status = way.status;
    report.cost += way.cost;
  }
}

/// From where the search kept clear of limits and keep-outs to where they are, along the path of
/// minima as the barrier on them fades, and one settling at its end. nullopt where that is not
/// certified, with the search's state back. [LIM-2]
std::optional<ExactDesign> HandleEditSolver::State::settle_at_limits(const NewtonOptions& options,
                                                                     const Progress& progress,
                                                                     SolveReport& report) {
  if (report.status == SolveStatus::kCancelled) return std::nullopt;
  const DisplacementField::Snapshot found = trial_->snapshot();
  const std::vector<int> support = newton_->support();
  NewtonOptions step = options;
  if (follows_softness()) step.last_smoothing = kCoarse;
  step.first_smoothing = step.last_smoothing;
  SolveReport near = report;
  while (problem_.limit_weight > kLastLimitWeight && near.status != SolveStatus::kCancelled) {
    problem_.limit_weight *= kLimitWeightShrink;
    const EngineOutcome way = newton_->run_warm(problem_, step, *trial_, progress);
    near.cost += way.cost;
    near.status = way.status;
  }
  ExactDesign design = settle(options, progress, near);
  problem_.limit_weight = kFirstLimitWeight;
  report.cost = near.cost;
  if (near.status == SolveStatus::kConverged || near.status == SolveStatus::kCancelled) {
    report = std::move(near);
    return design;
  }
  trial_->restore(found);
  newton_->set_support(support);
  return std::nullopt;
}

/// From the soft end of the scale, where there is one minimum, down to the softness asked for, each
/// from the last: so the edits of all softnesses lie on one branch, and none is a fold that a
/// cold start fell into. [SOF-2]
EngineOutcome HandleEditSolver::State::soften(const NewtonOptions& options,
                                              const Progress& progress) {
  constexpr double kDown = 2.5;  // of the scale's 10, at most, between two
  constexpr double kWarm = 0.015;
  NewtonOptions step = options;
  step.last_smoothing = kCoarse;  // settle() goes on from its own first ε
  step.stop = 1e-3;
  step.max_steps = std::min(options.max_steps, budget().coarse);
  HandleEditOptions now = options_;
  now.softness = kSoftest;
  terms_->assign(targets_, now, problem_);
  trial_->clear();
  EngineOutcome outcome = newton_->run_cold(problem_, {3, 16, 0.05}, step, *trial_, progress);
  step.first_smoothing = kWarm;
  for (bool last = false; !last && outcome.status != SolveStatus::kCancelled;) {
    now.softness = std::max(options_.softness, now.softness - kDown);
    last = now.softness == options_.softness;
    terms_->assign(targets_, now, problem_);
    if (last) {
      step.stop = options.stop;
      step.max_steps = std::min(options.max_steps, budget().last);
    }
    EngineOutcome next = newton_->run_warm(problem_, step, *trial_, progress);
    next.cost += outcome.cost;
    outcome = std::move(next);
  }
  terms_->assign(targets_, options_, problem_);
  return outcome;
}

/// From the state that a search left to a certified design, or to the design of that state.
ExactDesign HandleEditSolver::State::settle(const NewtonOptions& options, const Progress& progress,
                                            SolveReport& report) {
  const DisplacementField::Snapshot found = trial_->snapshot();
  const std::vector<int> support = newton_->support();
  const bool spent = options_.max_iterations > 0 && report.status == SolveStatus::kIterationLimit;
  if (report.status != SolveStatus::kCancelled && !spent) {
    EngineOutcome fine;
    ExactDesign design;
    const int most = has_keep_outs() ? kMostRestTurns : kMostOutlineTurns;
    for (int round = 0;
         round == 0 || (round < most && (turns(design) || (has_keep_outs() && lets_go())));
         ++round) {
      fine = newton_->settle(problem_, options, *trial_, progress);
      report.cost += fine.cost;
      design = finish_->finish(problem_, newton_->support(), *trial_, kept_);
    }
    if (is_acceptable(design)) {
      report.optimality = newton_->optimality(problem_, design.vertices, design.displacement);
      if (!report.optimality->met()) take_slow_movers_along(design, report);
      report.status = fine.status == SolveStatus::kCancelled ? fine.status
                      : report.optimality->met()             ? SolveStatus::kConverged
                                                             : SolveStatus::kIterationLimit;
      return design;
    }
    report.cost += design.cost;
    report.status = SolveStatus::kIterationLimit;
    trial_->restore(found);
    newton_->set_support(support);
  }
  ExactDesign design = finish_->finish(problem_, support, *trial_, kept_);
  if (has_keep_outs()) hold_back(support, design);
  return design;
}

/// The design with what hardly moves moving, where that is what the certificate lacks.
void HandleEditSolver::State::take_slow_movers_along(ExactDesign& design, SolveReport& report) {
  newton_->keep_slow_movers(*trial_);
  ExactDesign other = finish_->finish(problem_, newton_->support(), *trial_, kept_);
  if (!is_acceptable(other)) return;
  const Optimality found = newton_->optimality(problem_, other.vertices, other.displacement);
  if (!found.met()) return;
  report.optimality = found;
  design = std::move(other);
}

ExactDesign HandleEditSolver::State::solve_augmented_lagrangian(const Progress& progress,
                                                                SolveReport& report) {
  trial_->clear();
  AlmOptions options;
  if (options_.max_iterations > 0) options.max_outer = options_.max_iterations;
  std::vector<int> support;
  const EngineOutcome outcome = solve_edit_by_alm(problem_, options, *trial_, support, progress);
  report.status = outcome.status;
  report.cost = outcome.cost;
  report.records = outcome.records;
  return finish_->finish(problem_, support, *trial_, kept_);
}

ExactDesign HandleEditSolver::State::run_engine(const Progress& progress, SolveReport& report) {
  return options_.engine == Engine::kNewton ? solve_newton(progress, report)
                                            : solve_augmented_lagrangian(progress, report);
}

}  // namespace planish
