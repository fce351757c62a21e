// SPDX-License-Identifier: MIT
/// The way in parts: for targets that a jump does not reach.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "edit/edit_search.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// The handles of a problem on their way to where they should be. The targets stand again after it.
class HandlesOnTheirWay {
 public:
  explicit HandlesOnTheirWay(EditProblem& problem) : problem_(problem) {
    for (const int v : problem.handles) targets_.push_back(problem.terms[at(v)].target);
  }
  HandlesOnTheirWay(const HandlesOnTheirWay&) = delete;
  HandlesOnTheirWay& operator=(const HandlesOnTheirWay&) = delete;
  ~HandlesOnTheirWay() { go_to_targets(); }

  void go_to(double share) {
    for (std::size_t k = 0; k < targets_.size(); ++k) term(k).target = share * targets_[k];
  }
  void go_to_targets() {
    for (std::size_t k = 0; k < targets_.size(); ++k) term(k).target = targets_[k];
  }

 private:
  VertexTerm& term(std::size_t k) { return problem_.terms[at(problem_.handles[k])]; }

  EditProblem& problem_;
  std::vector<Eigen::Vector3d> targets_;
};

bool is_outline(const PointSupport& support) {
  return support.kind == PointSupport::Kind::kOutline;
}

}  // namespace

EditSearch::OtherTargets::OtherTargets(EditSearch& search, const EditTargets& now)
    : search_(search), asked_(search.model_.targets()) {
  take(now);
}

EditSearch::OtherTargets::~OtherTargets() { take(asked_); }

void EditSearch::OtherTargets::take(const EditTargets& targets) {
  search_.model_.set_targets(targets);
  search_.model_.pose(targets, search_.posed_options());
}

/// Goes one part of the way, with the active set that it asks for.
ExactDesign EditSearch::advance(bool cold, const NewtonOptions& options, const Progress& progress,
                                SolveReport& report) {
  const EngineOutcome outcome =
      cold ? newton_.run_cold(model_.problem(), {3, 0, 0.05}, options, field_, progress)
           : newton_.run_warm(model_.problem(), options, field_, progress);
  report.status = outcome.status;
  report.cost += outcome.cost;
  update_active_set(options, progress, report);
  return design();
}

/// The handles moved in parts, each part acceptable before the next: slower, and it always ends on
/// an acceptable design, though perhaps short of the targets. A part that fails is tried at half
/// its length, a few times in all.
ExactDesign EditSearch::solve_in_parts(const Progress& progress, SolveReport& report) {
  constexpr double kFirstPart = 0.125;
  constexpr double kShortestPart = 0.125 / 16;
  NewtonOptions options = engine_options();
  options.stop = 1e-5;
  options.max_steps = parts_budget().part;
  const int most = report.cost.factorizations + parts_budget().all;
  HandlesOnTheirWay handles(model_.problem());
  ExactDesign best = EditModel::unmoved();
  field_.clear();
  model_.active_set().reset();
  newton_.set_support(model_.problem().handles);
  report.status = SolveStatus::kInfeasibleHandles;
  double reached = 0.0;
  for (double part = kFirstPart;
       reached < 1.0 && part >= kShortestPart && report.cost.factorizations < most;) {
    const Place before = place();
    const double share = std::min(1.0, reached + part);
    handles.go_to(share);
    SolveReport way;
    ExactDesign next = advance(reached == 0.0, options, progress, way);
    report.cost += way.cost;
    if (model_.is_acceptable(next)) {
      best = std::move(next);
      reached = share;
    } else {
      go_back(before);
      part *= 0.5;
    }
    if (way.status == SolveStatus::kCancelled) {
      report.status = SolveStatus::kCancelled;
      break;
    }
  }
  handles.go_to_targets();
  if (reached < 1.0 || report.status == SolveStatus::kCancelled) return best;
  report.status = SolveStatus::kIterationLimit;
  ExactDesign settled = settle(options, progress, report);
  if (model_.is_acceptable(settled)) return settled;
  report.optimality.reset();
  return best;
}

/// What stands for targets that no flat design was found for: handles that may stay short of them,
/// approached in parts, then pulled less far. The base mesh is the last resort, and always valid.
ExactDesign EditSearch::fall_back(const Progress& progress, SolveReport& report) {
  const bool hard = model_.options().hard_handles;
  if (hard && model_.is_bounded()) {  // a jump starts beyond the barrier, a path does not
    ExactDesign design = solve_in_parts(progress, report);
    if (report.status != SolveStatus::kInfeasibleHandles) return design;
  }
  softens_handles_ = true;
  model_.pose(model_.targets(), posed_options());
  ExactDesign design = solve_in_parts(progress, report);
  if (stops_short(kFarShort, design, report)) find_nearer(progress, design, report);
  if (hard) pull_harder(progress, design, report);
  softens_handles_ = false;
  model_.pose(model_.targets(), posed_options());
  if (hard && report.status != SolveStatus::kCancelled) {
    report.status = SolveStatus::kInfeasibleHandles;
    hold_at_targets(progress, design, report);
  }
  return design;
}

/// Takes soft handles that stand for hard ones nearer to their targets than the balance with the
/// edit's other terms: by weights that grow, for as long as that moves them.
void EditSearch::pull_harder(const Progress& progress, ExactDesign& design, SolveReport& report) {
  constexpr double kHarder[] = {10.0, 100.0, 1000.0};  // of the attraction
  if (!may_look_on()) return;
  const NewtonOptions options = engine_options();
  load(design);
  for (const double factor : kHarder) {
    if (report.status == SolveStatus::kCancelled) return;
    model_.pose(model_.targets(), posed_options());
    for (const int v : model_.problem().handles) {
      model_.problem().terms[at(v)].square_weight *= factor;
    }
    SolveReport firm;
    firm.cost = newton_.run_warm(model_.problem(), options, field_, progress).cost;
    ExactDesign nearer = settle(options, progress, firm);
    report.cost += firm.cost;
    if (firm.status == SolveStatus::kCancelled) report.status = firm.status;
    if (!model_.is_acceptable(nearer)) return;
    if (model_.handle_distance(nearer) >= model_.handle_distance(design)) return;
    design = std::move(nearer);
    report.optimality = firm.optimality;
  }
}

/// Holds hard handles where soft ones in their place came to the targets.
void EditSearch::hold_at_targets(const Progress& progress, ExactDesign& design,
                                 SolveReport& report) {
  constexpr double kArrived = 1e-2;  // of the pull
  if (model_.handle_distance(design) > kArrived * handle_scale(model_.problem())) return;
  load(design);
  SolveReport held;
  ExactDesign there = settle(engine_options(), progress, held);
  report.cost += held.cost;
  if (held.status == SolveStatus::kCancelled) report.status = held.status;
  if (held.status != SolveStatus::kConverged || !model_.is_acceptable(there)) return;
  design = std::move(there);
  report.status = held.status;
  report.optimality = held.optimality;
}

/// Whether handles stop short by more than a share of their way, without a certificate: a jump may
/// end against the barrier, far from the targets and from any minimum.
bool EditSearch::stops_short(double share, const ExactDesign& design,
                             const SolveReport& report) const {
  if (is_certified(report) || report.status == SolveStatus::kCancelled) return false;
  return model_.handle_distance(design) > share * handle_scale(model_.problem());
}

/// The design of another way, where there was none that is acceptable, or it ends lower, or at the
/// same place with a certificate.
void EditSearch::try_way(const FindDesign& way, ExactDesign& design, SolveReport& report) {
  constexpr double kSame = 1e-6;  // of the objective
  SolveReport other;
  const double before = objective_or_infinite(design);  // by the active set that it ended with
  ExactDesign found = way(other);
  other.cost += report.cost;
  other.records = std::move(report.records);
  if (objective_or_infinite(found) < (is_certified(other) ? 1.0 + kSame : 1.0) * before) {
    design = std::move(found);
  } else {
    stand_at(design);
    if (other.status != SolveStatus::kCancelled) other.status = report.status;
    other.optimality = report.optimality;
  }
  report = std::move(other);
}

/// Takes the active set of a design that another one, or another search, was solved after.
void EditSearch::stand_at(const ExactDesign& design) {
  model_.active_set().reset();
  model_.active_set().update(design);
}

/// Infinite where a design is not acceptable.
double EditSearch::objective_or_infinite(const ExactDesign& design) {
  return model_.is_acceptable(design) ? model_.objective(design).total()
                                      : std::numeric_limits<double>::infinity();
}

/// Whether an edit may look beside its search: by Newton's method, with all of its steps.
bool EditSearch::may_look_on() const {
  return model_.options().engine == Engine::kNewton && model_.options().max_iterations == 0;
}

bool EditSearch::has_outlines() const {
  const std::vector<PointSupport>& supports = model_.targets().supports;
  return may_look_on() && std::any_of(supports.begin(), supports.end(), is_outline);
}

/// The targets of an edit with all of its outlines' points pinned, but for handles.
EditTargets EditSearch::with_outlines_pinned() const {
  EditTargets held = model_.targets();
  const std::vector<int>& handles = model_.problem().handles;
  for (const PointSupport& support : held.supports) {
    if (!is_outline(support)) continue;
    for (const int v : points_of(support, model_.mesh_model().mesh)) {
      if (!std::binary_search(handles.begin(), handles.end(), v)) held.pins.push_back(v);
    }
  }
  return held;
}

/// Points on outlines rest until there is a minimum, and slide from there: where they slide at once
/// they may take a panel to the bound of its shape. [SUP-3]
void EditSearch::slide_from_pinned_outlines(const Progress& progress, ExactDesign& design,
                                            SolveReport& report) {
  const auto slide = [&](SolveReport& way) {
    std::optional<ExactDesign> start = solve_with_pinned_outlines(progress, way);
    if (!start) return EditModel::unmoved();
    way.optimality.reset();  // with the points pinned it was
    way.status = SolveStatus::kIterationLimit;
    ExactDesign free = *start;
    for (const bool runs : {false, true}) {  // straight to a minimum near by, or as searches go
      if (is_certified(way) || way.status == SolveStatus::kCancelled) break;
      const auto go_on = [&](SolveReport& on) {
        load(*start);
        if (runs) advance(false, engine_options(), progress, on);
        return settle(engine_options(), progress, on);
      };
      try_way(go_on, free, way);
    }
    return free;
  };
  if (!model_.is_acceptable(design)) stand_at(design);
  try_way(slide, design, report);
}

/// nullopt where there is none that is acceptable.
std::optional<ExactDesign> EditSearch::solve_with_pinned_outlines(const Progress& progress,
                                                                  SolveReport& report) {
  const OtherTargets pinned(*this, with_outlines_pinned());
  model_.active_set().reset();
  ExactDesign start = solve_newton(progress, report);
  if (report.status == SolveStatus::kCancelled || !model_.is_acceptable(start)) return std::nullopt;
  return start;
}

/// An edit whose targets are at a part of the way.
EditSearch::Pull EditSearch::pull(double part, const Progress& progress) {
  constexpr double kFollowed = 0.15;  // of the pull: handles that are so near have followed it
  Pull pull;
  pull.part = part;
  bool acceptable = false;
  {
    const OtherTargets nearer(*this, part_of(model_.targets(), part));
    model_.active_set().reset();
    pull.design = solve_newton(progress, pull.report);
    acceptable = model_.is_acceptable(pull.design);
    pull.follows = acceptable && model_.handle_distance(pull.design) <=
                                     kFollowed * handle_scale(model_.problem());
  }
  if (acceptable) pull.left = model_.handle_distance(pull.design);
  return pull;
}

/// Nearer targets, in place of those that a search got nowhere with: the design that gets nearest
/// to those that were asked for. The engine ends where it is. [PTH-2]
void EditSearch::find_nearer(const Progress& progress, ExactDesign& design, SolveReport& report) {
  constexpr double kFirst = 0.65;       // of the way: the first pull
  constexpr double kFirstEdges = 16.0;  // it is no longer
  constexpr double kBack = 0.4;         // of a pull that its handles do not follow: the next
  constexpr double kFine = 1.25;        // the ratio of two pulls: nothing is looked for between
  constexpr int kMostPulls = 4;
  constexpr int kMostFactorizations = 1000;
  constexpr int kMostOnAShortWay = 150;
  if (!may_look_on()) return;
  const int most =
      report.cost.factorizations + (is_short_way() ? kMostOnAShortWay : kMostFactorizations);
  double nearest = model_.handle_distance(design);
  double low = 0.0;
  double high = 1.0;
  double best = 0.0;
  double last = 0.0;
  double part = std::min(kFirst, kFirstEdges / handle_scale(model_.problem()));
  const auto take = [&](Pull next) {
    report.cost += next.report.cost;
    if (next.report.status == SolveStatus::kCancelled) report.status = SolveStatus::kCancelled;
    if (next.left > nearest) return;
    nearest = next.left;
    best = next.part;
    design = std::move(next.design);
  };
  for (int k = 0; k < kMostPulls && high > kFine * low && report.cost.factorizations < most; ++k) {
    Pull next = pull(part, progress);
    (next.follows ? low : high) = last = part;
    part = low > 0.0 ? std::sqrt(low * high) : kBack * part;
    // Where a certified design leaves its handles behind, those of a shorter pull stay, too.
    const bool stuck = !next.follows && next.report.status == SolveStatus::kConverged;
    take(std::move(next));
    if (stuck || report.status == SolveStatus::kCancelled) break;
  }
  if (best == 0.0) return;
  report.optimality.reset();
  if (report.status == SolveStatus::kCancelled) return;
  report.status = SolveStatus::kInfeasibleHandles;
  if (best != last) take(pull(best, progress));
}

}  // namespace planish
