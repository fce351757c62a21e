// SPDX-License-Identifier: MIT
/// Newton's steps on the Lagrangian of (8) on one patch.
#pragma once

#include <Eigen/Core>

#include "engines/largest.hpp"
#include "engines/patch_system.hpp"
#include "engines/primal_dual_step.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// With the exact curvature of rows, bound and norms; no state on the way is beyond the bound.
class PatchNewton {
 public:
  /// A factor serves one step, or as many full steps as halve.
  enum class Factors { kFresh, kChords };

  explicit PatchNewton(Factors factors, RowRule rows = RowRule::kEquations) : factors_(factors) {
    options_.rows = rows;
  }

  /// @param patch must outlive this, or the next attach()
  /// @param state within the bound
  void attach(const Patch& patch, PatchState state);

  /// ε > 0 of √(‖d‖² + ε²).
  void set_smoothing(double smoothing);
  /// μ > 0 of [WSN-2].
  void set_penalty(double penalty);

  /// False when no step helps any more.
  [[nodiscard]] bool step();

  /// ‖∇L_ε‖ of the worst vertex.
  [[nodiscard]] double gradient_norm();
  [[nodiscard]] double length() const { return length_; }  ///< of the last step, mean edges
  [[nodiscard]] double violation() const { return largest_entry(residuals_); }
  /// Largest |λ|.
  [[nodiscard]] double pull() const { return largest_entry(state_.multipliers); }
  [[nodiscard]] double objective() const {
    return system_.lagrangian().energy(state_.displacement, 0.0);
  }
  [[nodiscard]] int factorizations() const { return system_.factorizations(); }
  [[nodiscard]] const PatchState& state() const { return state_; }
  /// Sets another state, within the bound.
  void set_state(PatchState state);
  /// ∇F + Jᵀλ at `displacement` without the norms' part, 3 × free.
  void pulls(const Eigen::Matrix3Xd& displacement, Eigen::Matrix3Xd& out) const;

 private:
  static constexpr double kChordProgress = 0.5;  ///< of a chord step's length to the last one's

  [[nodiscard]] bool take_chord();

  Factors factors_;
  StepOptions options_;
  PatchSystem system_;
  PrimalDualStep step_;
  PatchState state_;
  double smoothing_ = 1.0;
  double length_ = 1.0;    ///< of the last step, mean edges
  bool factored_ = false;  ///< the last factor may serve a chord step
  Eigen::Matrix3Xd gradient_, delta_, trial_;
  Eigen::VectorXd residuals_, trial_residuals_, linear_, no_residuals_;
};

}  // namespace planish
