// SPDX-License-Identifier: MIT
/// The way in parts: for targets that a jump does not reach.
#include <algorithm>
#include <limits>
#include <utility>

#include "edit/handle_edit_state.hpp"
#include "planish/numeric/index.hpp"

namespace planish {

/// The handles moved in parts, each part acceptable before the next: slower, and it always ends on
/// an acceptable design, though perhaps short of the targets. A part that fails is tried at half
/// its length, a few times in all.
ExactDesign HandleEditSolver::State::solve_in_parts(const Progress& progress, SolveReport& report) {
  constexpr double kFirstPart = 0.125;
  constexpr double kShortestPart = 0.125 / 16;
  NewtonOptions options = engine_options();
  options.stop = 1e-5;
  options.max_steps = follows_softness() ? budget().part : 60;
  const int most = follows_softness() ? report.cost.factorizations + budget().all_parts
                                      : std::numeric_limits<int>::max();
  std::vector<Eigen::Vector3d> targets;
  for (const int v : problem_.handles) targets.push_back(problem_.terms[at(v)].target);
  ExactDesign best = unmoved();
  trial_->clear();
  open_tracks();
  newton_->set_support(problem_.handles);
  report.status = SolveStatus::kInfeasibleHandles;
  double reached = 0.0;
  for (double part = kFirstPart;
       reached < 1.0 && part >= kShortestPart && report.cost.factorizations < most;) {
    const DisplacementField::Snapshot before = trial_->snapshot();
    const std::vector<int> support = newton_->support();
    const double share = std::min(1.0, reached + part);
    for (std::size_t k = 0; k < targets.size(); ++k) {
      problem_.terms[at(problem_.handles[k])].target = share * targets[k];
    }
    const EngineOutcome outcome =
        reached == 0.0 ? newton_->run_cold(problem_, {3, 0, 0.05}, options, *trial_, progress)
                       : newton_->run_warm(problem_, options, *trial_, progress);
    report.cost += outcome.cost;
    SolveReport turned;
    turned.status = outcome.status;
    choose_sides(options, progress, turned);
    report.cost += turned.cost;
    ExactDesign next = finish_->finish(problem_, newton_->support(), *trial_, kept_);
    if (is_acceptable(next)) {
      best = std::move(next);
      reached = share;
    } else {
      trial_->restore(before);
      newton_->set_support(support);
      part *= 0.5;
    }
    if (outcome.status == SolveStatus::kCancelled) {
      report.status = SolveStatus::kCancelled;
      break;
    }
  }
  for (std::size_t k = 0; k < targets.size(); ++k) {
    problem_.terms[at(problem_.handles[k])].target = targets[k];
  }
  if (reached < 1.0 || report.status == SolveStatus::kCancelled) return best;
  report.status = SolveStatus::kIterationLimit;
  ExactDesign settled = settle(options, progress, report);
  if (is_acceptable(settled)) return settled;
  report.optimality.reset();
  return best;
}

/// For targets that no flat design was found for: handles that may stay short of them, approached
/// in parts. The base mesh is the last resort, and always valid.
ExactDesign HandleEditSolver::State::come_nearer(const Progress& progress, SolveReport& report) {
  const std::vector<VertexTerm> terms = problem_.terms;
  const bool softened = std::any_of(problem_.handles.begin(), problem_.handles.end(),
                                    [&](int v) { return problem_.terms[at(v)].fixed; });
  if (softened && is_bounded()) {  // a jump starts beyond the barrier, a path does not
    ExactDesign design = solve_in_parts(progress, report);
    if (report.status != SolveStatus::kInfeasibleHandles) return design;
  }
  for (const int v : problem_.handles) problem_.terms[at(v)].fixed = false;
  ExactDesign design = solve_in_parts(progress, report);
  problem_.terms = terms;
  if (softened && report.status != SolveStatus::kCancelled) {
    report.status = SolveStatus::kInfeasibleHandles;
  }
  return design;
}

/// A jump may end against the barrier, far from the target and from any minimum.
bool HandleEditSolver::State::stops_short(const ExactDesign& design,
                                          const SolveReport& report) const {
  constexpr double kFar = 0.05;  // of the move
  const bool certified = report.optimality && report.optimality->met();
  if (!is_bounded() || certified || report.status == SolveStatus::kCancelled) return false;
  return handle_distance(design) > kFar * handle_scale(problem_);
}

/// The way in parts, where it ends lower.
void HandleEditSolver::State::try_in_parts(const Progress& progress, ExactDesign& design,
                                           SolveReport& report) {
  SolveReport other;
  ExactDesign nearer = solve_in_parts(progress, other);
  const double reached = design_objective(problem_, design, *cutter_).total();
  const bool lower = design_objective(problem_, nearer, *cutter_).total() < reached;
  other.cost += report.cost;
  other.records = std::move(report.records);
  if (!lower) {
    other.status = report.status;
    other.optimality = report.optimality;
  } else {
    design = std::move(nearer);
  }
  report = std::move(other);
}

}  // namespace planish
