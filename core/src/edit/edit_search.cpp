// SPDX-License-Identifier: MIT
#include "edit/edit_search.hpp"

#include <utility>

#include "edit/edit_reach.hpp"
#include "edit/switching/parting_planes.hpp"
#include "engines/augmented_lagrangian.hpp"
#include "engines/cold_search.hpp"

namespace planish {

EditSearch::EditSearch(EditModel& model)
    : model_(model),
      newton_(model.mesh_model()),
      field_(model.mesh_model().vertex_count(),
             static_cast<int>(model.mesh_model().equations.size())) {}

bool EditSearch::follows_softness() const {
  return model_.options().softness > 0.0 && has_reach(model_.options());
}

HandleEditOptions EditSearch::posed_options() const {
  HandleEditOptions options = model_.options();
  if (softens_handles_) options.hard_handles = false;
  return options;
}

bool EditSearch::is_limited() const { return !model_.options().bounds.empty(); }

/// Whether a way is one that a jump goes as well as parts of it do.
bool EditSearch::is_short_way() const {
  constexpr double kShortWay = 2.0;  // mean edges
  return handle_scale(model_.problem()) <= kShortWay;
}

/// Along the softness, without stated limits, a short way ends where parts would.
bool EditSearch::parts_help() const {
  const bool ends_there = model_.options().engine == Engine::kNewton && follows_softness() &&
                          !is_limited() && is_short_way();
  return model_.is_bounded() && !ends_there;
}

/// What takes more ends no lower; where many stated limits act, late steps still pay.
EditSearch::Budget EditSearch::budget() const {
  constexpr Budget kPlain{40, 60, 25, 80};
  constexpr Budget kLimited{80, 120, 60, 150};
  return is_limited() ? kLimited : kPlain;
}

EditSearch::PartsBudget EditSearch::parts_budget() const {
  constexpr PartsBudget kAnywhere{60, 1500};
  constexpr PartsBudget kPlain{25, 150};
  constexpr PartsBudget kLimited{40, 300};
  if (!follows_softness()) return kAnywhere;
  return is_limited() ? kLimited : kPlain;
}

/// Within a reach the problem is small and steep, its multipliers are large; elsewhere the engine's
/// own tuning stands.
NewtonOptions EditSearch::engine_options() const {
  NewtonOptions options;
  if (follows_softness()) {
    options.step.penalty = 1e8;
    options.step.poor_share = 0.3;
    options.max_first_settle_steps = budget().first_settle;
    options.max_settle_steps = budget().settle;
  }
  if (model_.options().max_iterations > 0) options.max_steps = model_.options().max_iterations;
  return options;
}

void EditSearch::go_back(const Place& place) {
  field_.restore(place.field);
  newton_.set_support(place.support);
}

ExactDesign EditSearch::find(const Progress& progress, SolveReport& report) {
  ExactDesign design = find_freely(progress, report);
  if (!is_certified(report) && report.status != SolveStatus::kCancelled && has_outlines()) {
    slide_from_pinned_outlines(progress, design, report);
  }
  return design;
}

ExactDesign EditSearch::find_freely(const Progress& progress, SolveReport& report) {
  model_.active_set().reset();
  ExactDesign design = run_engine(progress, report);
  if (!model_.is_acceptable(design)) {
    report.optimality.reset();
    if (report.status == SolveStatus::kCancelled) return EditModel::unmoved();
    return fall_back(progress, report);
  }
  if (report.status == SolveStatus::kSingularSystem) {
    report.status = SolveStatus::kIterationLimit;  // exact, only perhaps not at a minimum
  }
  constexpr double kShort = 0.05;
  const bool open_hard = model_.options().hard_handles && may_look_on() && !is_certified(report);
  if (open_hard ? model_.is_bounded() : parts_help() && stops_short(kShort, design, report)) {
    try_way([&](SolveReport& way) { return solve_in_parts(progress, way); }, design, report);
  }
  if (stops_short(kFarShort, design, report)) find_nearer(progress, design, report);
  return design;
}

ExactDesign EditSearch::run_engine(const Progress& progress, SolveReport& report) {
  return model_.options().engine == Engine::kNewton ? solve_newton(progress, report)
                                                    : solve_augmented_lagrangian(progress, report);
}

/// Search, then down to where keep-outs are, then the certificate.
ExactDesign EditSearch::solve_newton(const Progress& progress, SolveReport& report) {
  const NewtonOptions options = engine_options();
  EngineOutcome outcome = model_.targets().continuation > 0 ? continue_from_base(options, progress)
                          : follows_softness()
                              ? soften(options, progress)
                              : find_minimum(model_.problem(), options, newton_, field_, progress);
  report.status = outcome.status;
  report.cost += outcome.cost;
  report.records = std::move(outcome.records);
  update_active_set(options, progress, report);
  if (model_.is_beside_keep_outs()) {
    if (auto design = settle_at_keep_outs(options, progress, report)) return std::move(*design);
  }
  return settle(options, progress, report);
}

ExactDesign EditSearch::solve_augmented_lagrangian(const Progress& progress, SolveReport& report) {
  field_.clear();
  AlmOptions options;
  options.executor = model_.options().executor.get();
  if (model_.options().max_iterations > 0) options.max_outer = model_.options().max_iterations;
  std::vector<int> support;
  EngineOutcome outcome = solve_edit_by_alm(model_.problem(), options, field_, support, progress);
  report.status = outcome.status;
  report.cost = outcome.cost;
  report.records = std::move(outcome.records);
  return model_.finish(support, field_);
}

/// Goes from the state that a search left to a certified design, or to the design of that state.
ExactDesign EditSearch::settle(const NewtonOptions& options, const Progress& progress,
                               SolveReport& report) {
  ActiveSet& active_set = model_.active_set();
  const Place found = place();
  const bool spent =
      model_.options().max_iterations > 0 && report.status == SolveStatus::kIterationLimit;
  if (report.status != SolveStatus::kCancelled && !spent) {
    EngineOutcome fine;
    const auto settle_once = [&] {
      fine = newton_.settle(model_.problem(), options, field_, progress);
      report.cost += fine.cost;
      return design();
    };
    // What presses or pulls says little at a state that is no minimum.
    constexpr int kMostUnsettled = 4;
    int unsettled = 0;
    const auto turn = [&](const ExactDesign& last) {
      if (fine.status != SolveStatus::kConverged && ++unsettled > kMostUnsettled) return false;
      return active_set.update(last) || release();
    };
    ExactDesign settled = settle_once();
    solve_until_steady(settled, active_set.most_rounds() - 1, settle_once, turn);
    if (model_.is_acceptable(settled)) {
      report.optimality = optimality(settled);
      if (!report.optimality->met()) refine(options, settled, report);
      if (!report.optimality->met()) include_slow_movers(settled, report);
      report.status = fine.status == SolveStatus::kCancelled ? fine.status
                      : report.optimality->met()             ? SolveStatus::kConverged
                                                             : SolveStatus::kIterationLimit;
      return settled;
    }
    report.cost += settled.cost;
    const bool cancelled = fine.status == SolveStatus::kCancelled;
    report.status = cancelled ? SolveStatus::kCancelled : SolveStatus::kIterationLimit;
    go_back(found);
  }
  ExactDesign clamped = design();
  solve_until_steady(
      clamped, kMostOutlineTurns, [&] { return design(); },
      [&](const ExactDesign& last) { return active_set.clamp(last); });
  return clamped;
}

/// The design of a state whose rows hold to rounding, where the certificate lacks that.
void EditSearch::refine(const NewtonOptions& options, ExactDesign& design, SolveReport& report) {
  report.cost += newton_.refine(model_.problem(), options, field_).cost;
  take_if_certified(design, report);
}

/// The design with what hardly moves moving, where that is what the certificate lacks.
void EditSearch::include_slow_movers(ExactDesign& design, SolveReport& report) {
  newton_.keep_slow_movers(field_);
  take_if_certified(design, report);
}

/// The design of the engine's state in place of one without a certificate.
void EditSearch::take_if_certified(ExactDesign& design, SolveReport& report) {
  ExactDesign other = this->design();
  if (!model_.is_acceptable(other)) return;
  const Optimality found = optimality(other);
  if (!found.met()) return;
  report.optimality = found;
  design = std::move(other);
}

bool EditSearch::release() {
  constexpr double kAtRest = 1e-6;  // of the pull
  ActiveSet& active_set = model_.active_set();
  return active_set.may_release() &&
         active_set.release(newton_.track_forces(), kAtRest * handle_scale(model_.problem()));
}

void EditSearch::set_field(const ExactDesign& design) {
  field_.clear();
  for (std::size_t k = 0; k < design.vertices.size(); ++k) {
    field_.set_displacement(design.vertices[k],
                            design.displacement.col(static_cast<Eigen::Index>(k)));
  }
}

/// The engine goes on from `design`.
void EditSearch::load(const ExactDesign& design) {
  set_field(design);
  newton_.set_support(design.vertices.empty() ? model_.problem().handles : design.vertices);
}

ExactDesign EditSearch::corrected(const ExactDesign& design) {
  set_field(design);
  return model_.finish(design.vertices, field_);
}

Optimality EditSearch::optimality(const ExactDesign& design) {
  return newton_.optimality(model_.problem(), design.vertices, design.displacement);
}

ExactDesign find_parted(EditModel& model, const FindDesign& find, SolveReport& report) {
  ExactDesign design = find(report);
  PartedPanels* const parted = model.parted_panels();
  if (parted == nullptr) return design;
  const auto find_again = [&] {
    if (report.status == SolveStatus::kCancelled) {
      report.optimality.reset();
      return EditModel::unmoved();
    }
    SolveReport next;
    next.cost = report.cost;
    report = std::move(next);
    return find(report);
  };
  const auto goes_through = [&](const ExactDesign& last) { return parted->update(last); };
  if (!solve_until_steady(design, parted->most_rounds(), find_again, goes_through) &&
      goes_through(design)) {
    if (report.usable()) report.status = SolveStatus::kInfeasibleHandles;
    report.optimality.reset();
    design = EditModel::unmoved();
  }
  return design;
}

}  // namespace planish
