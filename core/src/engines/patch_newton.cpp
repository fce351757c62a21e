// SPDX-License-Identifier: MIT
#include "engines/patch_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace planish {
void PatchNewton::attach(const Patch& patch, PatchState state) {
  system_.attach(patch);
  shift_ = 0.0;
  length_ = 1.0;
  zero_.setZero(3, patch.free_count);
  set_state(std::move(state));
}

void PatchNewton::set_state(PatchState state) {
  state_ = std::move(state);
  factored_ = false;
  system_.lagrangian().residuals(state_.displacement, residuals_);
}

void PatchNewton::set_smoothing(double smoothing) {
  smoothing_ = smoothing;
  factored_ = false;
}

void PatchNewton::set_penalty(double penalty) {
  penalty_ = penalty;
  factored_ = false;
}

double PatchNewton::gradient_norm() {
  system_.lagrangian().gradient_at(state_, smoothing_, gradient_);
  return gradient_.cols() > 0 ? gradient_.colwise().norm().maxCoeff() : 0.0;
}

void PatchNewton::pulls(const Eigen::Matrix3Xd& displacement, Eigen::Matrix3Xd& out) const {
  const PatchState there{displacement, state_.norm_dual, state_.multipliers};
  system_.lagrangian().gradient_at(there, std::numeric_limits<double>::infinity(), out);
}

bool PatchNewton::step() {
  if (rows_ == Rows::kSprings) state_.multipliers = penalty_ * residuals_;
  system_.lagrangian().gradient_at(state_, smoothing_, gradient_);
  if (factored_ && take_chord()) return true;
  if (!factorize()) return false;
  find_direction();
  if (search_line()) return true;
  shift_ = std::max(10.0 * shift_, kFirstShift);
  factored_ = false;
  length_ = 1.0;  // a refused step is not the end
  return shift_ < kLargestShift;
}

bool PatchNewton::factorize() {
  while (!system_.factorize(state_, smoothing_, penalty_, shift_)) {
    shift_ = std::max(4.0 * shift_, kFirstShift);
    if (!(shift_ < kLargestShift)) return false;
  }
  factored_ = factors_ == Factors::kChords;
  return true;
}

void PatchNewton::find_direction() {
  if (rows_ == Rows::kSprings) {
    remainder_.setZero(residuals_.size());  // the pull is in the gradient
    system_.step(gradient_, remainder_, delta_);
    return;
  }
  system_.step(gradient_, residuals_, delta_);
  system_.apply_jacobian(delta_, linear_);
  new_multipliers_ = state_.multipliers + penalty_ * (residuals_ + linear_);
}

/// A full step with the last factor, where it halves what the step before was.
bool PatchNewton::take_chord() {
  find_direction();
  const double length = delta_.colwise().norm().maxCoeff();
  if (!(length <= kChordProgress * length_) || shift_ > 0.0) return false;
  trial_ = state_.displacement + delta_;
  if (!std::isfinite(system_.lagrangian().energy(trial_, 0.0))) return false;
  system_.lagrangian().residuals(trial_, trial_residuals_);
  accept(1.0);
  return true;
}

double PatchNewton::merit(const Eigen::Matrix3Xd& d, const Eigen::VectorXd& c) const {
  if (rows_ == Rows::kSprings) {
    return system_.lagrangian().energy(d, smoothing_) + 0.5 * penalty_ * c.squaredNorm();
  }
  const double weight = std::min(penalty_, kMeritPenalty);
  return system_.lagrangian().energy(d, smoothing_) + new_multipliers_.dot(c) +
         0.5 * weight * c.squaredNorm();
}

bool PatchNewton::search_line() {
  constexpr int kMostHalvings = 12;
  constexpr double kRounding = 1e-11;
  const double start = merit(state_.displacement, residuals_);
  const double longest = delta_.colwise().norm().maxCoeff();
  if (!std::isfinite(longest)) return false;
  double share = std::min(1.0, kTrust / std::max(longest, 1e-300));
  for (int halving = 0; halving < kMostHalvings; ++halving, share *= 0.5) {
    trial_ = state_.displacement + share * delta_;
    system_.lagrangian().residuals(trial_, trial_residuals_);
    double reached = merit(trial_, trial_residuals_);
    remainder_ = trial_residuals_ - (1.0 - share) * residuals_;
    system_.step(zero_, remainder_, correction_);
    correction_ += trial_;
    system_.lagrangian().residuals(correction_, linear_);
    const double corrected = merit(correction_, linear_);
    if (corrected < reached) {
      reached = corrected;
      trial_.swap(correction_);
      trial_residuals_.swap(linear_);
    }
    if (reached <= start + kRounding * std::abs(start)) {
      accept(share);
      if (share == 1.0 && shift_ > 0.0) shift_ = shift_ < 1e-3 ? 0.0 : 0.2 * shift_;
      factored_ = factored_ && share == 1.0 && shift_ == 0.0;
      return true;
    }
  }
  return false;
}

void PatchNewton::accept(double share) {
  length_ = (trial_ - state_.displacement).colwise().norm().maxCoeff();
  state_.displacement.swap(trial_);  // trial_ is the state before the step from here on
  residuals_.swap(trial_residuals_);
  if (rows_ == Rows::kEquations) {
    state_.multipliers += share * (new_multipliers_ - state_.multipliers);
  }
  update_norm_duals(trial_, smoothing_, state_);
}

}  // namespace planish
