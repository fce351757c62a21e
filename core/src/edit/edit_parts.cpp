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

}  // namespace

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
  if (model_.options().engine != Engine::kNewton || model_.options().max_iterations > 0) return;
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
  const bool certified = report.optimality && report.optimality->met();
  if (certified || report.status == SolveStatus::kCancelled) return false;
  return model_.handle_distance(design) > share * handle_scale(model_.problem());
}

/// The way in parts, where it ends lower, or at the same place with a certificate.
void EditSearch::try_in_parts(const Progress& progress, ExactDesign& design, SolveReport& report) {
  SolveReport other;
  ExactDesign nearer = solve_in_parts(progress, other);
  other.cost += report.cost;
  other.records = std::move(report.records);
  constexpr double kSame = 1e-6;  // of the objective
  const double found = model_.objective(design).total();
  const bool certified = other.optimality && other.optimality->met();
  if (model_.objective(nearer).total() < (certified ? 1.0 + kSame : 1.0) * found) {
    design = std::move(nearer);
  } else {
    if (other.status != SolveStatus::kCancelled) other.status = report.status;
    other.optimality = report.optimality;
  }
  report = std::move(other);
}

/// An edit whose targets are at a part of the way; the targets that were asked for stand after it.
EditSearch::Pull EditSearch::pull(double part, const Progress& progress) {
  constexpr double kFollowed = 0.15;  // of the pull: handles that are so near have followed it
  const EditTargets asked = model_.targets();
  model_.set_targets(part_of(asked, part));
  model_.pose(model_.targets(), posed_options());
  model_.active_set().reset();
  Pull pull;
  pull.part = part;
  pull.design = solve_newton(progress, pull.report);
  const bool acceptable = model_.is_acceptable(pull.design);
  pull.follows = acceptable &&
                 model_.handle_distance(pull.design) <= kFollowed * handle_scale(model_.problem());
  model_.set_targets(asked);
  model_.pose(asked, posed_options());
  pull.left =
      acceptable ? model_.handle_distance(pull.design) : std::numeric_limits<double>::infinity();
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
  if (model_.options().engine != Engine::kNewton || model_.options().max_iterations > 0) return;
  const int most = report.cost.factorizations + kMostFactorizations;
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
