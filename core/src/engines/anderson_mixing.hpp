// SPDX-License-Identifier: MIT
/// Anderson acceleration of a fixed-point iteration x ← g(x). [PRO-5]
#pragma once

#include <Eigen/Core>
#include <array>

namespace planish {

/// Keeps the last few iterates and steps f(x) = g(x) − x, and replaces the next step by the one
/// that the secants predict to be the last:
///
///   x⁺ = x + f − Σ γ_j (Δx_j + Δf_j),   γ = argmin ‖f − Σ γ_j Δf_j‖
///
/// Walker and Ni 2011 (type II). Memory 2 × 5 iterates.
class AndersonMixing {
 public:
  /// @param x where the step was computed; @param step f(x) in, x⁺ − x out, the same size as x
  void accelerate(const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& step);

  /// Forgets everything: after a step that was not taken whole.
  void restart();

 private:
  static constexpr int kWindow = 5;

  Eigen::Matrix3Xd last_x_, last_step_;
  std::array<Eigen::Matrix3Xd, kWindow> x_differences_, step_differences_;
  Eigen::Matrix<double, kWindow, kWindow> gram_;  ///< Δf_i · Δf_j
  int filled_ = 0;                                ///< differences kept
  int next_ = 0;                                  ///< the one that is replaced next
};

}  // namespace planish
