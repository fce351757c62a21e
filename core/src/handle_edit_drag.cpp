// SPDX-License-Identifier: MIT
/// One frame of a drag.
#include <utility>

#include "handle_edit_state.hpp"
#include "planish/stopwatch.hpp"

namespace planish {
HandleEditResult HandleEditSolver::State::drag(const EditTargets& targets, double budget_seconds) {
  const Stopwatch watch;
  set_targets(targets);
  const bool fresh = !last_exact_ || drag_support_.empty();
  if (slides_ != nullptr) fresh || nothing_to_do() ? slides_->open() : slides_->release_corners();
  if (nothing_to_do()) {  // back where the drag began: the path that led here is forgotten
    drag_support_.clear();
    last_exact_ = unmoved();
    SolveReport report;
    report.status = SolveStatus::kConverged;
    return result_of(*last_exact_, std::move(report));
  }
  NewtonOptions options;
  options.stop = 3e-5;
  // A frame that changes to another minimum may take dozens of steps; the next frames go on with
  // it.
  options.max_steps = 7;
  const Interruption out_of_time = [&](const IterationRecord&) {
    return watch.seconds() > budget_seconds;
  };
  SolveReport report;
  NewtonOutcome outcome;
  if (fresh) {
    field_->clear();
    outcome = newton_->run_cold(problem_, {3, 16, 0.05}, options, *field_, out_of_time);
  } else {
    options.first_smoothing = 1e-3;
    newton_->set_support(drag_support_);
    outcome = newton_->run_warm(problem_, options, *field_, out_of_time);
  }
  drag_support_ = newton_->support();
  report.status =
      outcome.status == SolveStatus::kCancelled ? SolveStatus::kIterationLimit : outcome.status;
  report.iterations = outcome.steps;
  report.factorizations = outcome.factorizations;
  ExactDesign design = finish_->finish(problem_, drag_support_, *field_, kept_);
  for (int turn = 0; turn < kMostOutlineTurns && turns(design);
       ++turn) {  // the next frames go on with it
    design = finish_->finish(problem_, drag_support_, *field_, kept_);
  }
  if (is_acceptable(design)) {
    last_exact_ = std::move(design);
  } else {  // the last exact state stands; the next frame starts afresh
    drag_support_.clear();
    report.status = SolveStatus::kIterationLimit;
  }
  HandleEditResult result = result_of(last_exact_ ? *last_exact_ : unmoved(), std::move(report));
  if (last_exact_) last_exact_->factorizations = 0;  // a frame that repeats it has not made them
  result.report.solve_seconds = watch.seconds();
  return result;
}

}  // namespace planish
