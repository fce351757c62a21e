// SPDX-License-Identifier: MIT
#include "engines/fair_flat.hpp"

#include <algorithm>
#include <cmath>

#include "engines/patch_system.hpp"

namespace planish {
namespace {

/// Figures of the iteration.
struct FairFlatTuning {
  static constexpr double kLastPenalty = 1e6;    ///< μ; 1/μ regularises nearly dependent rows
  static constexpr double kStageFactor = 100.0;  ///< between two stages' μ
  static constexpr double kFlat = 1e-5;   ///< residual that the exact finish takes to rounding
  static constexpr double kRough = 1e-3;  ///< step that ends all stages but the last
  static constexpr int kStageSteps = 25;  ///< of all stages but the last
};

class FairFlat {
  static constexpr double kTrust = 0.5;          ///< longest step of a vertex, mean edges
  static constexpr double kNoNorm = 1.0;         ///< ε of norm terms that are not there
  static constexpr double kFirstShift = 1e-2;    ///< ν
  static constexpr double kLargestShift = 1e6;   ///< ν beyond which no step leads anywhere
  static constexpr double kMeritPenalty = 1e5;   ///< ρ at most: larger shortens steps along curves
  static constexpr double kChordProgress = 0.5;  ///< of a chord step's length to the last one's

 public:
  FairFlat(const Patch& patch, const Eigen::Matrix3Xd& start) {
    system_.attach(patch);
    state_.displacement = start;
    state_.norm_dual.setZero(3, patch.free_count);
    state_.multipliers.setZero(static_cast<Eigen::Index>(patch.equations.size()));
    zero_.setZero(3, patch.free_count);
    system_.residuals(start, residuals_);
  }

  void set_penalty(double penalty) {
    penalty_ = penalty;
    factored_ = false;
  }

  /// False when no step helps any more.
  [[nodiscard]] bool step() {
    system_.lagrangian_gradient(state_, kNoNorm, gradient_);
    if (factored_ && take_chord()) return true;
    if (!factorize()) return false;
    find_direction();
    if (search_line()) return true;
    shift_ = std::max(10.0 * shift_, kFirstShift);
    factored_ = false;
    length_ = 1.0;  // a refused step is not the end
    return shift_ < kLargestShift;
  }

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double violation() const {
    return residuals_.size() > 0 ? residuals_.cwiseAbs().maxCoeff() : 0.0;
  }
  [[nodiscard]] double objective() const { return system_.energy(state_.displacement, 0.0); }
  [[nodiscard]] int factorizations() const { return system_.factorizations(); }
  [[nodiscard]] const Eigen::Matrix3Xd& displacement() const { return state_.displacement; }

 private:
  [[nodiscard]] bool factorize() {
    while (!system_.factorize(state_, kNoNorm, penalty_, shift_)) {
      shift_ = std::max(4.0 * shift_, kFirstShift);
      if (!(shift_ < kLargestShift)) return false;
    }
    factored_ = true;
    return true;
  }

  void find_direction() {
    system_.step(gradient_, residuals_, delta_);
    system_.apply_jacobian(delta_, linear_);
    new_multipliers_ = state_.multipliers + penalty_ * (residuals_ + linear_);
  }

  /// A full step with the last factor, where it halves what the step before was.
  [[nodiscard]] bool take_chord() {
    find_direction();
    const double length = delta_.colwise().norm().maxCoeff();
    if (!(length <= kChordProgress * length_) || shift_ > 0.0) return false;
    trial_ = state_.displacement + delta_;
    if (!std::isfinite(system_.energy(trial_, 0.0))) return false;
    system_.residuals(trial_, trial_residuals_);
    accept(1.0);
    return true;
  }

  [[nodiscard]] double merit(const Eigen::Matrix3Xd& d, const Eigen::VectorXd& c) const {
    const double weight = std::min(penalty_, kMeritPenalty);
    return system_.energy(d, 0.0) + new_multipliers_.dot(c) + 0.5 * weight * c.squaredNorm();
  }

  /// Backtracks on F + λ⁺ᵀc + ρ/2 ‖c‖², each trial corrected to second order with the same factor.
  [[nodiscard]] bool search_line() {
    constexpr int kMostHalvings = 12;
    constexpr double kRounding = 1e-11;
    const double start = merit(state_.displacement, residuals_);
    const double longest = delta_.colwise().norm().maxCoeff();
    if (!std::isfinite(longest)) return false;
    double share = std::min(1.0, kTrust / std::max(longest, 1e-300));
    for (int halving = 0; halving < kMostHalvings; ++halving, share *= 0.5) {
      trial_ = state_.displacement + share * delta_;
      system_.residuals(trial_, trial_residuals_);
      double reached = merit(trial_, trial_residuals_);
      remainder_ = trial_residuals_ - (1.0 - share) * residuals_;
      system_.step(zero_, remainder_, correction_);
      correction_ += trial_;
      system_.residuals(correction_, linear_);
      const double corrected = merit(correction_, linear_);
      if (corrected < reached) {
        reached = corrected;
        trial_.swap(correction_);
        trial_residuals_.swap(linear_);
      }
      if (reached <= start + kRounding * std::abs(start)) {
        accept(share);
        if (share == 1.0 && shift_ > 0.0) shift_ = shift_ < 1e-3 ? 0.0 : 0.2 * shift_;
        factored_ = share == 1.0 && shift_ == 0.0;
        return true;
      }
    }
    return false;
  }

  void accept(double share) {
    length_ = (trial_ - state_.displacement).colwise().norm().maxCoeff();
    state_.displacement.swap(trial_);
    residuals_.swap(trial_residuals_);
    state_.multipliers += share * (new_multipliers_ - state_.multipliers);
  }

  PatchSystem system_;
  PatchState state_;
  double penalty_ = 1.0;
  double shift_ = 0.0;     ///< ν
  double length_ = 1.0;    ///< of the last step, mean edges
  bool factored_ = false;  ///< the last factor may serve a chord step
  Eigen::Matrix3Xd gradient_, delta_, trial_, correction_, zero_;
  Eigen::VectorXd residuals_, trial_residuals_, linear_, new_multipliers_, remainder_;
};

/// One stage; true when it ended by itself.
bool run_stage(FairFlat& solver, int most_steps, double settled, const Progress& progress,
               EngineOutcome& outcome) {
  for (int k = 0; k < most_steps; ++k) {
    ++outcome.steps;
    if (!solver.step()) return false;
    outcome.records.push_back({.objective = solver.objective(),
                               .primal_residual = solver.violation(),
                               .step = solver.length()});
    if (progress && progress(outcome.records.back()) == Flow::kStop) {
      outcome.status = SolveStatus::kCancelled;
      return false;
    }
    if (solver.length() <= settled) return true;
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
  FairFlat solver(patch, displacement);
  for (double penalty = options.first_penalty; penalty < FairFlatTuning::kLastPenalty;
       penalty *= FairFlatTuning::kStageFactor) {
    solver.set_penalty(penalty);
    run_stage(solver, std::min(FairFlatTuning::kStageSteps, options.max_steps - outcome.steps),
              FairFlatTuning::kRough, progress, outcome);
    if (outcome.status == SolveStatus::kCancelled) break;
  }
  if (outcome.status != SolveStatus::kCancelled) {
    solver.set_penalty(FairFlatTuning::kLastPenalty);
    const bool settled =
        run_stage(solver, options.max_steps - outcome.steps, options.settled, progress, outcome);
    if (settled && solver.violation() <= FairFlatTuning::kFlat)
      outcome.status = SolveStatus::kConverged;
  }
  displacement = solver.displacement();
  outcome.factorizations = solver.factorizations();
  return outcome;
}

}  // namespace planish
