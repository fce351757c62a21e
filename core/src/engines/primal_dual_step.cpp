// SPDX-License-Identifier: MIT
#include "engines/primal_dual_step.hpp"

#include <algorithm>
#include <cmath>

#include "engines/largest.hpp"

namespace planish {
namespace {

constexpr double kFirstShift = 1e-2;   ///< first ν tried when the system is not positive definite
constexpr double kLargestShift = 1e6;  ///< beyond it the step is shorter than any progress
constexpr double kLeastShift = 1e-3;   ///< below it ν is dropped

}  // namespace

void PrimalDualStep::attach(PatchSystem& system, int free_count) {
  system_ = &system;
  pulls_.setZero(3, free_count);
  limits_.attach(system);
  fresh_ = true;
}

double PrimalDualStep::violation() const { return largest_entry(trial_residuals_); }

/// M(d, λ) = F + λₑᵀc + μ/2 ‖c‖² + 1/(2μ) ‖λₑ + μc − λ‖²
double PrimalDualStep::merit(const Point& point) const {
  const double mu = options_.penalty;
  const auto& c = point.residuals;
  return system_->lagrangian().energy(point.displacement, smoothing_) + estimate_.dot(c) +
         0.5 * mu * c.squaredNorm() +
         0.5 / mu * (estimate_ + mu * c - point.multipliers).squaredNorm() + point.limits;
}

/// λₑ follows λ only where |c| or |∇L| fell to half of its record, so the function stays the same
/// while steps descend on it. Expects the gradient and the rows of `state`.
void PrimalDualStep::hold_estimate(const PatchState& state) {
  constexpr double kOther = 1e-5;  // share of the other measure in each
  constexpr double kFall = 0.5;
  const double off = std::max(largest_entry(residuals_), limits_.violation(state));
  const double slope = longest_column(gradient_);
  const double feasible = off + kOther * slope, optimal = kOther * off + slope;
  has_new_estimate_ = fresh_;
  if (fresh_) {
    constexpr double kRoom = 1e-3;
    feasible_record_ = 2.0 * feasible + kRoom;
    optimal_record_ = 2.0 * optimal;
    merit_tolerance_ = 0.1;
    fresh_ = false;
  }
  has_new_estimate_ = has_new_estimate_ || wants_estimate_;
  wants_estimate_ = false;
  const bool is_nearer = feasible <= kFall * feasible_record_;
  const bool is_flatter = optimal <= kFall * optimal_record_;
  if (is_nearer) feasible_record_ *= kFall;
  if (is_flatter) optimal_record_ *= kFall;
  has_new_estimate_ = has_new_estimate_ || is_nearer || is_flatter;
  constexpr double kMostMultiplier = 1e6;
  if (options_.rows == RowRule::kSprings) {
    estimate_.setZero(residuals_.size());
  } else if (has_new_estimate_) {
    estimate_ = state.multipliers.cwiseMax(-kMostMultiplier).cwiseMin(kMostMultiplier);
    limits_.hold_estimate(state);
  }
}

bool PrimalDualStep::factorize(const PatchState& state) {
  while (!system_->factorize(state, smoothing_, options_.penalty, shift_)) {
    shift_ = std::max(4.0 * shift_, kFirstShift);
    if (!(shift_ < kLargestShift)) return false;
  }
  return true;
}

/// δ, λ⁺ and z⁺ by the factor. The merit falls along them wherever there is a factor, and the rows
/// that are active at the state are those of the factor.
void PrimalDualStep::find_direction(const PatchState& state) {
  const double mu = options_.penalty;
  remainder_ = estimate_ - state.multipliers;
  pulls_ = gradient_;
  system_->add_pulls(remainder_, pulls_);
  limits_.add_without_pressure(state, pulls_);  // now ∇F + Jᵀλₑ
  const auto with_limits = [&]() -> const Eigen::Matrix3Xd& {
    if (limits_.empty()) return pulls_;
    trial_ = pulls_;
    limits_.add_pulls(trial_);
    return trial_;
  };
  system_->step(with_limits(), residuals_, delta_);
  system_->apply_jacobian(delta_, linear_);
  limits_.take_direction(delta_);
  new_multipliers_ = estimate_ + mu * (residuals_ + linear_);
  decrease_ = -(pulls_.cwiseProduct(delta_).sum() + mu * residuals_.dot(linear_)) +
              (estimate_ + mu * residuals_ - state.multipliers).squaredNorm() / mu +
              limits_.decrease(state);
}

/// The direction that is the minimum of the step's own model, limits linearised: which of them are
/// active is found with one factor, by solves. Where it is not found the direction is the one of
/// the rows that press at the state, along which the merit falls. [LIM-2]
bool PrimalDualStep::find_step(const PatchState& state) {
  constexpr int kMostChanges = 8;
  limits_.activate();
  if (!factorize(state)) return false;
  find_direction(state);
  if (limits_.empty()) return true;
  for (int change = 0; change < kMostChanges; ++change) {
    const double reach = longest_column(delta_);
    if (!limits_.activate_along(std::min(1.0, options_.trust / std::max(reach, 1e-300)))) break;
    if (!system_->update()) {
      if (options_.limits_may_stay) limits_.keep_what_goes();
      const bool updated = options_.limits_may_stay && system_->update();
      if (!updated && !factorize(state)) return false;
    }
    find_direction(state);
  }
  if (decrease_ > 0.0) return true;
  limits_.activate_pressing();
  if (!factorize(state)) return false;
  find_direction(state);
  return true;
}

/// Corrects to second order along the rows, with the same factor: `correction_` from `trial_`.
void PrimalDualStep::correct(double share) {
  remainder_ = trial_residuals_ - (1.0 - share) * residuals_;
  pulls_.setZero();
  limits_.add_correction(share, pulls_);
  system_->step(pulls_, remainder_, correction_);
  correction_ += trial_;
  system_->lagrangian().residuals(correction_, linear_);
}

/// Backtracks on the merit; a trial that fails, or leaves the rows, is corrected.
bool PrimalDualStep::search_line(const PatchState& state) {
  constexpr int kMostHalvings = 12;
  constexpr double kArmijo = 1e-4;
  constexpr double kRounding = 1e-11;
  constexpr double kLeaves = 4.0;  // growth of ‖c‖²
  const double start = merit_before_;
  const double reach = longest_column(delta_);
  if (!std::isfinite(reach)) return false;
  length_ = std::min(1.0, options_.trust / std::max(reach, 1e-300));
  double inside = length_;  // what a bound cuts says nothing about the direction
  for (int halving = 0; halving < kMostHalvings; ++halving, length_ *= 0.5) {
    trial_ = state.displacement + length_ * delta_;
    trial_multipliers_ = state.multipliers + length_ * (new_multipliers_ - state.multipliers);
    system_->lagrangian().residuals(trial_, trial_residuals_);
    merit_after_ = merit(
        {trial_, trial_residuals_, trial_multipliers_, limits_.try_at(trial_, state, length_)});
    const double wanted = start - kArmijo * length_ * decrease_ + kRounding * std::abs(start);
    if (!(merit_after_ <= wanted) ||
        trial_residuals_.squaredNorm() > kLeaves * residuals_.squaredNorm()) {
      correct(length_);
      const double corrected = merit(
          {correction_, linear_, trial_multipliers_, limits_.try_at(correction_, state, length_)});
      if (corrected < merit_after_) {
        merit_after_ = corrected;
        trial_.swap(correction_);
        trial_residuals_.swap(linear_);
      }
    }
    if (merit_after_ <= wanted) {
      cut_ = length_ / inside;
      return true;
    }
    if (!std::isfinite(merit_after_)) inside = 0.5 * length_;
  }
  return false;
}

void PrimalDualStep::adapt_shift() {
  constexpr double kFade = 0.2;
  constexpr double kMostGrowth = 10.0;
  if (cut_ == 1.0 && shift_ > 0.0) shift_ = shift_ < kLeastShift ? 0.0 : kFade * shift_;
  if (cut_ < options_.poor_share) {
    shift_ = std::max(shift_ * std::min(kMostGrowth, 0.5 / cut_), kFirstShift);
  }
}

PrimalDualStep::Result PrimalDualStep::take(const StepOptions& options, double smoothing,
                                            PatchState& state) {
  constexpr double kNearMinimum = 1e-2;  // of the tolerance
  options_ = options;
  smoothing_ = smoothing;
  system_->lagrangian().residuals(state.displacement, residuals_);
  system_->lagrangian().gradient_at(state, smoothing, gradient_);
  limits_.begin(state, options.limit_penalty);
  hold_estimate(state);
  if (!find_step(state)) return Result::kBroken;
  if (!has_new_estimate_ && decrease_ <= kNearMinimum * merit_tolerance_) {
    merit_tolerance_ *= 0.5;
    wants_estimate_ = true;
  }
  merit_before_ =
      merit({state.displacement, residuals_, state.multipliers, limits_.merit_at(state)});
  if (!std::isfinite(merit_before_)) return Result::kBroken;
  if (!search_line(state)) {
    shift_ = std::max(10.0 * shift_, kFirstShift);
    return shift_ < kLargestShift ? Result::kRejected : Result::kBroken;
  }
  largest_move_ = longest_column(trial_ - state.displacement);
  state.displacement.swap(trial_);  // trial_ is the state before the step from here on
  state.multipliers.swap(trial_multipliers_);
  limits_.accept(state);
  update_norm_duals(trial_, smoothing, state);
  adapt_shift();
  return Result::kAccepted;
}

}  // namespace planish
