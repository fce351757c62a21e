// SPDX-License-Identifier: MIT
/// The frames of a drag, and the same path again as a solve.
#include <utility>

#include "edit/handle_edit_state.hpp"
#include "planish/numeric/stopwatch.hpp"

namespace planish {

/// A frame's steps, from the support that the engine holds or, `fresh`, from nothing.
EngineOutcome HandleEditSolver::State::follow(bool fresh, DisplacementField& field,
                                              const Progress& progress) {
  NewtonOptions options;
  options.stop = 3e-5;
  // A frame that changes to another minimum may take dozens of steps; the next frames go on with
  // it.
  options.max_steps = 7;
  if (fresh) {
    field.clear();
    return newton_->run_cold(problem_, {3, 16, 0.05}, options, field, progress);
  }
  options.first_smoothing = 1e-3;
  return newton_->run_warm(problem_, options, field, progress);
}

/// As a drag in equal steps would, one that is not acceptable included: the next starts afresh. At
/// the targets it goes on to a minimum. [PTH-1]
EngineOutcome HandleEditSolver::State::continue_from_base(const NewtonOptions& options,
                                                          const Progress& progress) {
  const EditTargets targets = targets_;
  EngineOutcome total;
  const auto keep = [&](EngineOutcome outcome) {
    outcome.cost += total.cost;
    total = std::move(outcome);
  };
  bool fresh = true;
  for (int step = 1; step <= targets.continuation; ++step) {
    EditTargets now = targets;
    const double share = static_cast<double>(step) / targets.continuation;
    for (Handle& handle : now.handles) {
      const Eigen::Vector3d base = model_->mesh.positions.col(handle.vertex);
      if (step < targets.continuation) handle.target = base + share * (handle.target - base);
    }
    terms_->assign(now, options_, problem_);
    keep(follow(fresh, *trial_, progress));
    if (total.status == SolveStatus::kCancelled) break;
    fresh = total.status == SolveStatus::kSingularSystem ||
            !is_acceptable(finish_->finish(problem_, newton_->support(), *trial_, kept_));
  }
  terms_->assign(targets, options_, problem_);
  if (total.status == SolveStatus::kCancelled) return total;
  NewtonOptions last = options;
  last.first_smoothing = 1e-3;
  keep(newton_->run_warm(problem_, last, *trial_, progress));
  return total;
}

void HandleEditSolver::State::forget_drag() {
  drag_support_.clear();
  last_exact_.reset();
  kept_frame_ = {};
}

void HandleEditSolver::State::keep_frame() {
  kept_frame_ = {drag_support_, last_exact_, field_->snapshot()};
}

void HandleEditSolver::State::go_back() {
  drag_support_ = kept_frame_.support;
  last_exact_ = kept_frame_.last_exact;
  field_->restore(kept_frame_.field);
}

HandleEditResult HandleEditSolver::State::drag(const EditTargets& targets, double budget_seconds) {
  const Stopwatch watch;
  set_targets(targets);
  const bool fresh = !last_exact_ || drag_support_.empty();
  if (fresh || nothing_to_do()) {
    open_tracks();
  } else if (slides_ != nullptr) {
    slides_->release_corners();
  }
  if (nothing_to_do()) {  // back where the drag began: the path that led here is forgotten
    drag_support_.clear();
    last_exact_ = unmoved();
    SolveReport report;
    report.status = SolveStatus::kConverged;
    return result_of(*last_exact_, std::move(report));
  }
  const Progress in_time = [&](const IterationRecord&) {
    return watch.seconds() > budget_seconds ? Flow::kStop : Flow::kContinue;
  };
  SolveReport report;
  if (!fresh) newton_->set_support(drag_support_);
  if (!fresh && has_keep_outs()) (void)turn_planes(*last_exact_);  // it may have been gone back to
  const EngineOutcome outcome = follow(fresh, *field_, in_time);
  drag_support_ = newton_->support();
  report.status =
      outcome.status == SolveStatus::kCancelled ? SolveStatus::kIterationLimit : outcome.status;
  report.cost = outcome.cost;
  if (has_keep_outs()) (void)lets_go();  // the next frames go on with it
  ExactDesign design = finish_->finish(problem_, drag_support_, *field_, kept_);
  for (int turn = 0; turn < kMostOutlineTurns && turns(design);
       ++turn) {  // the next frames go on with it
    design = finish_->finish(problem_, drag_support_, *field_, kept_);
  }
  const bool acceptable =
      is_acceptable(design) && !(has_keep_outs() && goes_through_itself(design));
  if (acceptable) last_exact_ = std::move(design);
  if (!acceptable || report.status == SolveStatus::kSingularSystem) {
    // No way on from here: the last exact state stands; the next frame starts afresh.
    drag_support_.clear();
    report.status = SolveStatus::kIterationLimit;
  }
  HandleEditResult result = result_of(last_exact_ ? *last_exact_ : unmoved(), std::move(report));
  if (last_exact_) last_exact_->cost = {};  // a frame that repeats it has not made them
  result.report.solve_seconds = watch.seconds();
  return result;
}

}  // namespace planish
