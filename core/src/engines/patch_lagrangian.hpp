// SPDX-License-Identifier: MIT
/// Objective, rows and Lagrangian of a patch at a state: what an iteration needs that factors
/// nothing. [PB-1]
#pragma once

#include <Eigen/Core>

#include "planish/numeric/index.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// Primal and dual variables of a patch, solver units.
struct PatchState {
  Eigen::Matrix3Xd displacement;  ///< 3 × free
  Eigen::Matrix3Xd norm_dual;     ///< 3 × free, w_i of Chan–Golub–Mulet, ‖w_i‖ ≤ 1
  Eigen::VectorXd multipliers;    ///< one per equation
  /// One per inequality, ≥ 0; 0 of those without. Empty: all are 0.
  Eigen::VectorXd limit_multipliers = {};
};

class PatchLagrangian {
 public:
  /// What the constraints are: c(p + d) = 0, or their linearisation J(p) d = 0 for tangent spaces.
  enum class Constraints { kExact, kLinearised };

  /// O(1). Keeps a reference to `patch`.
  void attach(const Patch& patch, Constraints constraints = Constraints::kExact) {
    patch_ = &patch;
    constraints_ = constraints;
  }

  /// F_ε(d), weights included; ε = 0 gives the objective itself. Infinite beyond the bound.
  [[nodiscard]] double energy(const Eigen::Matrix3Xd& displacement, double smoothing) const;

  /// ∇F_ε + Jᵀλ − Gᵀz at `state`, 3 × free, with G of the shares; ε = ∞ leaves the norms out.
  void gradient_at(const PatchState& state, double smoothing, Eigen::Matrix3Xd& out) const;

  /// c(points + d).
  void residuals(const Eigen::Matrix3Xd& displacement, Eigen::VectorXd& out) const;

  /// How well each inequality with a multiplier is kept, kLimitMargin aside; 1 of the others.
  void shares(const Eigen::Matrix3Xd& displacement, Eigen::VectorXd& out) const;

  /// Where the row is evaluated: at the state, or on the undisplaced patch for its linearisation.
  template <ConstraintRow Row>
  [[nodiscard]] RowPoints<Row::kArity> points_of(const Row& row,
                                                 const Eigen::Matrix3Xd& displacement) const {
    if (constraints_ == Constraints::kExact) return corners_at(*patch_, displacement, row);
    RowPoints<Row::kArity> result;
    for (int k = 0; k < Row::kArity; ++k) result.col(k) = patch_->points.col(row.vertices[at(k)]);
    return result;
  }

  /// x ← P x: only along what vertices with supports may do. [SUP-2]
  void slide(Eigen::Matrix3Xd& x) const;

 private:
  void fairness_gradient(const Eigen::Matrix3Xd& displacement, Eigen::Matrix3Xd& out) const;
  void inequality_gradient(const PatchState& state, Eigen::Matrix3Xd& out) const;
  [[nodiscard]] Eigen::Vector3d displaced(const Eigen::Matrix3Xd& displacement, int v) const;

  const Patch* patch_ = nullptr;
  Constraints constraints_ = Constraints::kExact;
};

}  // namespace planish
