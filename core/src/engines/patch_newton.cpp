// SPDX-License-Identifier: MIT
#include "engines/patch_newton.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace planish {
void PatchNewton::attach(const Patch& patch, PatchState state) {
  system_.attach(patch);
  step_.attach(system_, patch.free_count);
  step_.forget_shift();
  length_ = 1.0;
  set_state(std::move(state));
}

void PatchNewton::set_state(PatchState state) {
  state_ = std::move(state);
  factored_ = false;
  step_.restart();
  system_.lagrangian().residuals(state_.displacement, residuals_);
}

void PatchNewton::set_smoothing(double smoothing) {
  smoothing_ = smoothing;
  factored_ = false;
  step_.restart();
}

void PatchNewton::set_penalty(double penalty) {
  options_.penalty = penalty;
  factored_ = false;
  step_.restart();
}

double PatchNewton::gradient_norm() {
  system_.lagrangian().gradient_at(state_, smoothing_, gradient_);
  return longest_column(gradient_);
}

void PatchNewton::pulls(const Eigen::Matrix3Xd& displacement, Eigen::Matrix3Xd& out) const {
  const PatchState there{displacement, state_.norm_dual, state_.multipliers};
  system_.lagrangian().gradient_at(there, std::numeric_limits<double>::infinity(), out);
}

bool PatchNewton::step() {
  if (options_.rows == RowRule::kSprings) state_.multipliers = options_.penalty * residuals_;
  if (factored_ && take_chord()) return true;
  factored_ = false;
  switch (step_.take(options_, smoothing_, state_)) {
    case PrimalDualStep::Result::kBroken:
      return false;
    case PrimalDualStep::Result::kRejected:
      length_ = 1.0;  // a refused step is not the end
      return true;
    case PrimalDualStep::Result::kAccepted:
      break;
  }
  length_ = step_.largest_move();
  factored_ = factors_ == Factors::kChords && step_.is_plain();
  residuals_ = step_.residuals();
  return true;
}

/// A full step with the last factor, where it halves what the step before was.
bool PatchNewton::take_chord() {
  system_.lagrangian().gradient_at(state_, smoothing_, gradient_);
  const bool springs = options_.rows == RowRule::kSprings;
  no_residuals_.setZero(residuals_.size());  // a spring's pull is in the gradient
  system_.step(gradient_, springs ? no_residuals_ : residuals_, delta_);
  const double length = delta_.colwise().norm().maxCoeff();
  if (!(length <= kChordProgress * length_)) return false;
  trial_ = state_.displacement + delta_;
  if (!std::isfinite(system_.lagrangian().energy(trial_, 0.0))) return false;
  system_.lagrangian().residuals(trial_, trial_residuals_);
  if (!springs) {
    system_.apply_jacobian(delta_, linear_);
    state_.multipliers += options_.penalty * (residuals_ + linear_);
  }
  state_.displacement.swap(trial_);  // trial_ is the state before the step from here on
  residuals_.swap(trial_residuals_);
  length_ = (state_.displacement - trial_).colwise().norm().maxCoeff();
  update_norm_duals(trial_, smoothing_, state_);
  return true;
}

}  // namespace planish
