// SPDX-License-Identifier: MIT
#include "engines/fair_flat.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "engines/patch_newton.hpp"

namespace planish {
namespace {

/// Figures of the iteration.
struct FairFlatTuning {
  static constexpr double kLastPenalty = 1e6;    ///< μ; 1/μ regularises nearly dependent rows
  static constexpr double kStageFactor = 100.0;  ///< between two stages' μ
  static constexpr double kFlat = 1e-5;   ///< residual that the exact finish takes to rounding
  static constexpr double kRough = 1e-3;  ///< step that ends all stages but the last
  static constexpr int kStageSteps = 25;  ///< of all stages but the last
  static constexpr int kPatience = 15;    ///< steps in which |c| must fall
  static constexpr double kFall = 0.7;    ///< to this share of the least before
  static constexpr double kHopelessPull = 1e3;  ///< |λ| that no flat mesh near by would need
  static constexpr double kNearlyFlat = 1e-3;   ///< |c| at which nothing is hopeless
};

/// Whether the rows pull ever harder and the panels do not become flatter: no flat mesh is near,
/// or none that the bound allows.
class Hopelessness {
 public:
  [[nodiscard]] bool is_seen(double violation, double pull) {
    if (violation <= FairFlatTuning::kFall * least_) {
      least_ = violation;
      since_ = 0;
    } else {
      ++since_;
    }
    return since_ >= FairFlatTuning::kPatience && least_ > FairFlatTuning::kNearlyFlat &&
           pull > FairFlatTuning::kHopelessPull;
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  int since_ = 0;  ///< steps
};

/// Runs one stage; true when it ended by itself, false where nothing comes of it or it was stopped.
bool run_stage(PatchNewton& solver, int most_steps, double settled, const Progress& progress,
               EngineOutcome& outcome) {
  Hopelessness hopelessness;
  for (int k = 0; k < most_steps; ++k) {
    ++outcome.cost.steps;
    if (!solver.step()) return false;
    outcome.records.push_back({.objective = solver.objective(),
                               .primal_residual = solver.violation(),
                               .step = solver.length()});
    if (progress && progress(outcome.records.back()) == Flow::kStop) {
      outcome.status = SolveStatus::kCancelled;
      return false;
    }
    if (solver.length() <= settled) return true;
    if (hopelessness.is_seen(solver.violation(), solver.pull())) return false;
  }
  return false;
}

}  // namespace

EngineOutcome find_fair_flat(const Patch& patch, const FairFlatOptions& options,
                             const Progress& progress, Eigen::Matrix3Xd& displacement) {
  EngineOutcome outcome;
  if (patch.free_count == 0) {
    outcome.status = SolveStatus::kConverged;
    return outcome;
  }
  PatchState start{displacement, Eigen::Matrix3Xd::Zero(3, patch.free_count),
                   Eigen::VectorXd::Zero(static_cast<Eigen::Index>(patch.equations.size()))};
  PatchNewton solver(PatchNewton::Factors::kChords);
  solver.attach(patch, std::move(start));
  for (double penalty = options.first_penalty; penalty < FairFlatTuning::kLastPenalty;
       penalty *= FairFlatTuning::kStageFactor) {
    solver.set_penalty(penalty);
    run_stage(solver, std::min(FairFlatTuning::kStageSteps, options.max_steps - outcome.cost.steps),
              FairFlatTuning::kRough, progress, outcome);
    if (outcome.status == SolveStatus::kCancelled) break;
  }
  if (outcome.status != SolveStatus::kCancelled) {
    solver.set_penalty(FairFlatTuning::kLastPenalty);
    const bool settled = run_stage(solver, options.max_steps - outcome.cost.steps, options.settled,
                                   progress, outcome);
    if (settled && solver.violation() <= FairFlatTuning::kFlat)
      outcome.status = SolveStatus::kConverged;
  }
  displacement = solver.state().displacement;
  outcome.cost.factorizations = solver.factorizations();
  return outcome;
}

}  // namespace planish
