// SPDX-License-Identifier: MIT
/// Newton's steps on the Lagrangian of (8) on one patch.
#pragma once

#include <Eigen/Core>

#include "engines/patch_system.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// With the exact curvature of rows, bound and norms. Steps are judged by F_ε + λ⁺ᵀc + ρ/2 ‖c‖²
/// along a line, each trial corrected to second order with the same factor. No state on the way is
/// beyond the bound.
class PatchNewton {
 public:
  /// A factor serves one step, or as many full steps as halve.
  enum class Factors { kFresh, kChords };

  /// What the rows do: hold at zero, or pull there with μ c alone, so that the state settles where
  /// F + μ/2 ‖c‖² is least. [PRO-7]
  enum class Rows { kEquations, kSprings };

  explicit PatchNewton(Factors factors, Rows rows = Rows::kEquations)
      : factors_(factors), rows_(rows) {}

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
  [[nodiscard]] double violation() const {
    return residuals_.size() > 0 ? residuals_.cwiseAbs().maxCoeff() : 0.0;
  }
  [[nodiscard]] double objective() const {
    return system_.lagrangian().energy(state_.displacement, 0.0);
  }
  [[nodiscard]] int factorizations() const { return system_.factorizations(); }
  [[nodiscard]] const PatchState& state() const { return state_; }
  /// To change it, within the bound.
  void set_state(PatchState state);
  /// ∇F + Jᵀλ at `displacement` without the norms' part, 3 × free.
  void pulls(const Eigen::Matrix3Xd& displacement, Eigen::Matrix3Xd& out) const;

 private:
  static constexpr double kTrust = 0.5;          ///< longest step of a vertex, mean edges
  static constexpr double kFirstShift = 1e-2;    ///< ν
  static constexpr double kLargestShift = 1e6;   ///< ν beyond which no step leads anywhere
  static constexpr double kMeritPenalty = 1e5;   ///< ρ at most: larger shortens steps along curves
  static constexpr double kChordProgress = 0.5;  ///< of a chord step's length to the last one's

  [[nodiscard]] bool factorize();
  void find_direction();
  [[nodiscard]] bool take_chord();
  [[nodiscard]] double merit(const Eigen::Matrix3Xd& d, const Eigen::VectorXd& c) const;
  [[nodiscard]] bool search_line();
  void accept(double share);

  Factors factors_;
  Rows rows_;
  PatchSystem system_;
  PatchState state_;
  double smoothing_ = 1.0;
  double penalty_ = 1.0;
  double shift_ = 0.0;     ///< ν
  double length_ = 1.0;    ///< of the last step, mean edges
  bool factored_ = false;  ///< the last factor may serve a chord step
  Eigen::Matrix3Xd gradient_, delta_, trial_, correction_, zero_;
  Eigen::VectorXd residuals_, trial_residuals_, linear_, new_multipliers_, remainder_;
};

}  // namespace planish
