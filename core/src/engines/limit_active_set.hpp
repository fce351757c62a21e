// SPDX-License-Identifier: MIT
/// The inequalities of a patch that have multipliers, as a step of PrimalDualStep sees them: who of
/// them is active, what they add to the merit, and what a step does to them. [LIM-2]
///
///   M = … + 1/(2μ) Σ [ y² − zₑ² + (y − z)² ],   y = max(0, zₑ − μ s(d))
///
/// with the multiplier z ≥ 0 of each, its estimate zₑ held as the equations' is. Where y > 0 the
/// row is one like the equations; an inactive one exerts exactly nothing.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engines/patch_system.hpp"

namespace planish {

/// The worst of −s, and of s where something presses.
[[nodiscard]] double complementarity(const Eigen::VectorXd& shares,
                                     const Eigen::VectorXd& multipliers);

class LimitActiveSet {
 public:
  /// O(patch). Keeps a reference to `system`.
  void attach(PatchSystem& system);

  [[nodiscard]] bool empty() const { return empty_; }

  /// Takes shares and their gradients at `state`, from which a step follows. @param penalty μ > 0
  void begin(PatchState& state, double penalty);

  /// zₑ ← z.
  void hold_estimate(const PatchState& state);

  /// @see complementarity()
  [[nodiscard]] double violation(const PatchState& state) const;

  /// Activates, for the next factorization, the limits that press at the state that begin() saw,
  /// and those that the last step on this patch ended with.
  void activate();
  /// Activates the limits that press at the state, and no others.
  void activate_pressing();
  /// Activates what a share of the direction makes active, and lets go of what presses no more at
  /// its end. @returns whether anything changed
  bool activate_along(double share);
  /// Activates what the last activate_along() let go of.
  void keep_what_goes();

  /// out += Gᵀ z: the gradient without what presses.
  void add_without_pressure(const PatchState& state, Eigen::Matrix3Xd& out) const;
  /// out += Gᵀ (μ s − zₑ) of the active ones.
  void add_pulls(Eigen::Matrix3Xd& out);
  /// Takes the direction: what it does to the shares, and the multipliers after a full step.
  void take_direction(const Eigen::Matrix3Xd& delta);
  /// −∇M·(δ, z⁺ − z), the part of the limits.
  [[nodiscard]] double decrease(const PatchState& state) const;

  /// A trial at a share of the direction. @returns the limits' part of its merit
  double try_at(const Eigen::Matrix3Xd& displacement, const PatchState& state, double share);
  /// The limits' part of the merit at the state itself.
  [[nodiscard]] double merit_at(const PatchState& state) const;
  /// out += μ Gᵀ (what curvature did to the active shares of the last trial).
  void add_correction(double share, Eigen::Matrix3Xd& out);
  /// The last trial's multipliers, none below zero.
  void accept(PatchState& state) const;

 private:
  [[nodiscard]] double merit(const Eigen::VectorXd& shares, const Eigen::VectorXd& pressures) const;
  [[nodiscard]] double pressure(double estimate, double share) const;

  PatchSystem* system_ = nullptr;
  bool empty_ = true;
  double penalty_ = 1.0;
  std::vector<char> active_, before_;             ///< before the last activate_along()
  Eigen::VectorXd estimate_;                      ///< zₑ
  Eigen::VectorXd shares_, along_, multipliers_;  ///< s; G δ; z⁺
  Eigen::VectorXd trial_shares_, trial_multipliers_, work_;
};

}  // namespace planish
