// SPDX-License-Identifier: MIT
#include "edit/edit_drag.hpp"

#include <utility>

#include "edit/switching/parting_planes.hpp"
#include "planish/numeric/stopwatch.hpp"

namespace planish {

EditDrag::EditDrag(EditModel& model, EditSearch& search)
    : model_(model),
      search_(search),
      field_(model.mesh_model().vertex_count(),
             static_cast<int>(model.mesh_model().equations.size())),
      revision_(model.revision()) {}

void EditDrag::forget_if_revised() {
  if (revision_ == model_.revision()) return;
  revision_ = model_.revision();
  now_ = {};
  kept_ = {};
}

void EditDrag::keep_frame() {
  forget_if_revised();
  kept_ = {now_, field_.snapshot()};
}

void EditDrag::go_back() {
  forget_if_revised();
  now_ = kept_.place;
  field_.restore(kept_.field);
}

/// The steps of a frame and the design that they lead to. What its active set needs beyond them is
/// for the next frames.
ExactDesign EditDrag::follow(bool fresh, const Progress& in_time, SolveReport& report) {
  ActiveSet& active_set = model_.active_set();
  if (fresh) {
    active_set.reset();
  } else {
    active_set.resume(*now_.exact);
    search_.newton().set_support(now_.support);
  }
  const EngineOutcome outcome = search_.follow(fresh, field_, in_time);
  now_.support = search_.newton().support();
  report.status =
      outcome.status == SolveStatus::kCancelled ? SolveStatus::kIterationLimit : outcome.status;
  report.cost = outcome.cost;
  (void)search_.release();
  const auto finish = [&] { return model_.finish(now_.support, field_); };
  ExactDesign design = finish();
  solve_until_steady(design, kMostOutlineTurns, finish,
                     [&](const ExactDesign& last) { return active_set.update(last); });
  return design;
}

HandleEditResult EditDrag::frame(double budget_seconds) {
  const Stopwatch watch;
  forget_if_revised();
  SolveReport report;
  if (model_.nothing_to_do()) {  // back where the drag began: the path that led here is forgotten
    model_.active_set().reset();
    now_ = {{}, EditModel::unmoved()};
    report.status = SolveStatus::kConverged;
    return model_.result_of(*now_.exact, std::move(report));
  }
  const Progress in_time = [&](const IterationRecord&) {
    return watch.seconds() > budget_seconds ? Flow::kStop : Flow::kContinue;
  };
  ExactDesign design = follow(!now_.exact || now_.support.empty(), in_time, report);
  PartedPanels* const parted = model_.parted_panels();
  const bool acceptable =
      model_.is_acceptable(design) && (parted == nullptr || !parted->update(design));
  if (acceptable) now_.exact = std::move(design);
  if (!acceptable || report.status == SolveStatus::kSingularSystem) {
    // No way on from here: the last exact state stands; the next frame starts afresh.
    now_.support.clear();
    report.status = SolveStatus::kIterationLimit;
  }
  HandleEditResult result =
      model_.result_of(now_.exact ? *now_.exact : EditModel::unmoved(), std::move(report));
  if (now_.exact) now_.exact->cost = {};  // a frame that repeats it has not made them
  result.report.solve_seconds = watch.seconds();
  return result;
}

}  // namespace planish
