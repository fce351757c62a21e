// SPDX-License-Identifier: MIT
#include "engines/limit_active_set.hpp"

#include <algorithm>
#include <cmath>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kMostPressure = 1e6;

}  // namespace

double complementarity(const Eigen::VectorXd& shares, const Eigen::VectorXd& multipliers) {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < shares.size(); ++i) {
    worst = std::max(worst, multipliers[i] > 0.0 ? std::abs(shares[i]) : -shares[i]);
  }
  return worst;
}

void LimitActiveSet::attach(PatchSystem& system) {
  system_ = &system;
  empty_ = !system.has_limits();
  active_.clear();
  estimate_.resize(0);
}

/// max(0, zₑ − μ s)
double LimitActiveSet::pressure(double estimate, double share) const {
  return std::max(0.0, estimate - penalty_ * share);
}

void LimitActiveSet::begin(PatchState& state, double penalty) {
  if (empty_) return;
  penalty_ = penalty;
  system_->lagrangian().shares(state.displacement, shares_);
  system_->evaluate_limits(state.displacement);
  if (state.limit_multipliers.size() != shares_.size()) {
    state.limit_multipliers.setZero(shares_.size());
  }
  if (estimate_.size() != shares_.size()) estimate_ = state.limit_multipliers;
}

void LimitActiveSet::hold_estimate(const PatchState& state) {
  if (!empty_) estimate_ = state.limit_multipliers.cwiseMin(kMostPressure);
}

double LimitActiveSet::violation(const PatchState& state) const {
  return empty_ ? 0.0 : complementarity(shares_, state.limit_multipliers);
}

void LimitActiveSet::activate() {
  if (empty_) return;
  active_.resize(at(static_cast<int>(shares_.size())));
  for (Eigen::Index i = 0; i < shares_.size(); ++i) {
    if (pressure(estimate_[i], shares_[i]) > 0.0) active_[static_cast<std::size_t>(i)] = 1;
  }
  system_->activate(active_, penalty_);
}

void LimitActiveSet::activate_pressing() {
  active_.clear();
  activate();
}

bool LimitActiveSet::activate_along(double share) {
  bool differs = false;
  before_ = active_;
  for (Eigen::Index i = 0; i < along_.size(); ++i) {
    char& active = active_[static_cast<std::size_t>(i)];
    const double way = active != 0 ? 1.0 : share;
    const char next = pressure(estimate_[i], shares_[i] + way * along_[i]) > 0.0 ? 1 : 0;
    differs = differs || next != active;
    active = next;
  }
  if (differs) system_->activate(active_, penalty_);
  return differs;
}

void LimitActiveSet::keep_what_goes() {
  for (std::size_t i = 0; i < active_.size(); ++i) active_[i] |= before_[i];
  system_->activate(active_, penalty_);
}

void LimitActiveSet::add_without_pressure(const PatchState& state, Eigen::Matrix3Xd& out) const {
  if (!empty_) system_->limit_jacobian().add_transposed(state.limit_multipliers, out);
}

void LimitActiveSet::add_pulls(Eigen::Matrix3Xd& out) {
  if (empty_) return;
  work_.setZero(shares_.size());
  for (Eigen::Index i = 0; i < shares_.size(); ++i) {
    if (active_[static_cast<std::size_t>(i)] != 0) work_[i] = penalty_ * shares_[i] - estimate_[i];
  }
  system_->limit_jacobian().add_transposed(work_, out);
}

void LimitActiveSet::take_direction(const Eigen::Matrix3Xd& delta) {
  if (empty_) return;
  system_->limit_jacobian().apply(delta, along_);
  multipliers_.setZero(shares_.size());
  for (Eigen::Index i = 0; i < shares_.size(); ++i) {
    if (active_[static_cast<std::size_t>(i)] == 0) continue;
    multipliers_[i] = estimate_[i] - penalty_ * (shares_[i] + along_[i]);
  }
}

double LimitActiveSet::decrease(const PatchState& state) const {
  double sum = 0.0;
  if (empty_) return sum;
  for (Eigen::Index i = 0; i < shares_.size(); ++i) {
    const double z = state.limit_multipliers[i];
    const double y = pressure(estimate_[i], shares_[i]);
    const double by_step = y > 0.0 ? -penalty_ * along_[i] : 0.0;
    sum -= (y * by_step + (y - z) * (by_step - (multipliers_[i] - z))) / penalty_;
  }
  return sum;
}

double LimitActiveSet::merit(const Eigen::VectorXd& shares,
                             const Eigen::VectorXd& pressures) const {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < shares.size(); ++i) {
    const double z = pressures[i], y = pressure(estimate_[i], shares[i]);
    sum += y * y - estimate_[i] * estimate_[i] + (y - z) * (y - z);
  }
  return 0.5 / penalty_ * sum;
}

double LimitActiveSet::merit_at(const PatchState& state) const {
  return empty_ ? 0.0 : merit(shares_, state.limit_multipliers);
}

double LimitActiveSet::try_at(const Eigen::Matrix3Xd& displacement, const PatchState& state,
                              double share) {
  if (empty_) return 0.0;
  system_->lagrangian().shares(displacement, trial_shares_);
  trial_multipliers_ = state.limit_multipliers + share * (multipliers_ - state.limit_multipliers);
  return merit(trial_shares_, trial_multipliers_);
}

void LimitActiveSet::add_correction(double share, Eigen::Matrix3Xd& out) {
  if (empty_) return;
  work_.setZero(shares_.size());
  for (Eigen::Index i = 0; i < shares_.size(); ++i) {
    if (active_[static_cast<std::size_t>(i)] == 0) continue;
    work_[i] = penalty_ * (trial_shares_[i] - shares_[i] - share * along_[i]);
  }
  system_->limit_jacobian().add_transposed(work_, out);
}

void LimitActiveSet::accept(PatchState& state) const {
  if (!empty_) state.limit_multipliers = trial_multipliers_.cwiseMax(0.0);
}

}  // namespace planish
