// SPDX-License-Identifier: MIT
/// The paths of a search: along the targets, from soft to hard, and down to keep-outs.
#include <algorithm>
#include <utility>

#include "edit/edit_search.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kFarSmoothing = 1e-3;  ///< that a frame which goes far comes down from, share
constexpr double kCoarse = 0.0045;      ///< smoothing that a search within a reach ends at, share
/// The ratio of two weights of the keep-outs' barrier, one after the other. [KEE-1]
constexpr double kKeepOutWeightShrink = 0.1;

/// Whether the handles of a frame are ahead of the last one by a little of what they have moved.
bool is_near(const EditProblem& problem, const DisplacementField& field) {
  constexpr double kNear = 0.3;
  const double near = kNear * handle_scale(problem);
  return std::all_of(problem.handles.begin(), problem.handles.end(), [&](int v) {
    return (problem.terms[at(v)].target - field.displacement(v)).norm() <= near;
  });
}

/// `next`, and what it took to get to where it began.
void go_on(EngineOutcome next, EngineOutcome& total) {
  next.cost += total.cost;
  total = std::move(next);
}

}  // namespace

EngineOutcome EditSearch::follow(bool fresh, DisplacementField& field, const Progress& progress) {
  NewtonOptions options;
  options.stop = 3e-5;
  if (fresh) {
    options.max_steps = 7;
    field.clear();
    return newton_.run_cold(model_.problem(), {3, 16, 0.05}, options, field, progress);
  }
  // What is near is followed at the last ε: from a larger one each frame would come down anew. A
  // frame that changes to another minimum may take dozens of steps; the next ones go on with it.
  options.first_smoothing =
      is_near(model_.problem(), field) ? options.last_smoothing : kFarSmoothing;
  options.max_steps = 6;
  return newton_.run_warm(model_.problem(), options, field, progress);
}

/// Targets at a part of the way from the base to those given.
EditTargets EditSearch::part_of(const EditTargets& targets, double part) const {
  EditTargets now = targets;
  for (Handle& handle : now.handles) {
    const Eigen::Vector3d base = model_.mesh_model().mesh.positions.col(handle.vertex);
    if (part < 1.0) handle.target = base + part * (handle.target - base);
  }
  return now;
}

/// Goes on as a drag in equal steps would, one that is not acceptable included: the next starts
/// afresh. At the targets it goes on to a minimum. [PTH-1]
EngineOutcome EditSearch::continue_from_base(const NewtonOptions& options,
                                             const Progress& progress) {
  const EditTargets targets = model_.targets();
  EngineOutcome total;
  bool fresh = true;
  for (int step = 1; step <= targets.continuation; ++step) {
    model_.pose(part_of(targets, static_cast<double>(step) / targets.continuation),
                posed_options());
    go_on(follow(fresh, field_, progress), total);
    if (total.status == SolveStatus::kCancelled) break;
    fresh = total.status == SolveStatus::kSingularSystem || !model_.is_acceptable(design());
  }
  model_.pose(targets, posed_options());
  if (total.status == SolveStatus::kCancelled) return total;
  NewtonOptions last = options;
  last.first_smoothing = 1e-3;
  go_on(newton_.run_warm(model_.problem(), last, field_, progress), total);
  return total;
}

/// Goes from the soft end of the scale, where there is one minimum, down to the softness asked for,
/// each from the last: so the edits of all softnesses lie on one branch, and none is a fold that a
/// cold start fell into. [SOF-2]
EngineOutcome EditSearch::soften(const NewtonOptions& options, const Progress& progress) {
  constexpr double kDown = 2.5;  // of the scale's 10, at most, between two
  constexpr double kWarm = 0.015;
  constexpr double kLimitPenalty = 60.0;  // μ of the limits once their multipliers are about known
  const HandleEditOptions asked = posed_options();
  NewtonOptions step = options;
  step.last_smoothing = kCoarse;  // settle() goes on from its own first ε
  step.stop = 1e-3;
  step.max_steps = std::min(options.max_steps, budget().coarse);
  HandleEditOptions now = asked;
  now.softness = kSoftest;
  model_.pose(model_.targets(), now);
  field_.clear();
  EngineOutcome total = newton_.run_cold(model_.problem(), {3, 16, 0.05}, step, field_, progress);
  step.first_smoothing = kWarm;
  step.step.limit_penalty = kLimitPenalty;
  for (bool last = false; !last && total.status != SolveStatus::kCancelled;) {
    now.softness = std::max(asked.softness, now.softness - kDown);
    last = now.softness == asked.softness;
    model_.pose(model_.targets(), now);
    if (last) {
      step.stop = options.stop;
      step.max_steps = std::min(options.max_steps, budget().last);
    }
    go_on(newton_.run_warm(model_.problem(), step, field_, progress), total);
  }
  model_.pose(model_.targets(), asked);
  return total;
}

/// Which side of its outline each point goes to, and which points keep-outs hold, before anything
/// is settled. [SUP-3] [KEE-2]
void EditSearch::update_active_set(const NewtonOptions& options, const Progress& progress,
                                   SolveReport& report) {
  ActiveSet& active_set = model_.active_set();
  if (!active_set.may_switch() || report.status == SolveStatus::kCancelled) return;
  NewtonOptions step = options;
  step.first_smoothing = 1e-3;
  const auto go_on_with_it = [&] {
    const EngineOutcome way = newton_.run_warm(model_.problem(), step, field_, progress);
    report.status = way.status;
    report.cost += way.cost;
    return design();
  };
  ExactDesign state = design();
  solve_until_steady(state, kMostOutlineTurns, go_on_with_it, [&](const ExactDesign& last) {
    return report.status != SolveStatus::kCancelled && active_set.update(last);
  });
}

/// Goes from where the search kept clear of keep-outs to where they are, along the path of minima
/// as the barrier on them fades, and one settling at its end. nullopt where that is not certified,
/// with the search's state back. [KEE-1]
std::optional<ExactDesign> EditSearch::settle_at_keep_outs(const NewtonOptions& options,
                                                           const Progress& progress,
                                                           SolveReport& report) {
  if (report.status == SolveStatus::kCancelled) return std::nullopt;
  const Place found = place();
  EditProblem& problem = model_.problem();
  NewtonOptions step = options;
  if (follows_softness()) step.last_smoothing = kCoarse;
  step.first_smoothing = step.last_smoothing;
  SolveReport near = report;
  while (problem.keep_out_weight > kLastKeepOutWeight && near.status != SolveStatus::kCancelled) {
    problem.keep_out_weight *= kKeepOutWeightShrink;
    const EngineOutcome way = newton_.run_warm(problem, step, field_, progress);
    near.cost += way.cost;
    near.status = way.status;
  }
  ExactDesign design = settle(options, progress, near);
  problem.keep_out_weight = kFirstKeepOutWeight;
  report.cost = near.cost;
  if (near.status == SolveStatus::kConverged || near.status == SolveStatus::kCancelled) {
    report = std::move(near);
    return design;
  }
  go_back(found);
  return std::nullopt;
}

}  // namespace planish
