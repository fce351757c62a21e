// SPDX-License-Identifier: MIT
/// Minimum-norm Newton steps back onto the constraints: the exact finish of every result. [COR-1]
///
///   δ = −Jᵀ (J Jᵀ + ρ I)⁻¹ c(d)
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engines/largest.hpp"
#include "engines/row_jacobian.hpp"
#include "engines/sparse_cholesky.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// Corrects the free vertices of a patch; the halo and everything outside never moves.
class ConstraintCorrection {
 public:
  /// Builds the pattern of J Jᵀ; O(patch). Keeps a reference to `patch`.
  /// @returns false when a vertex carries so many equations that J Jᵀ would be dense
  [[nodiscard]] bool attach(const Patch& patch);

  /// Linearises at `displacement` (3 × free). False if the factorization failed.
  [[nodiscard]] bool factorize(const Eigen::Matrix3Xd& displacement, double regularization);

  /// δ for the residuals c with the Jacobian of the last factorization; multipliers y = −(…)⁻¹ c.
  void step(const Eigen::VectorXd& residuals, Eigen::Matrix3Xd& delta);

  /// J δ with J of the last factorization.
  void apply_jacobian(const Eigen::Matrix3Xd& delta, Eigen::VectorXd& out) const;

  /// x ← (I − Jᵀ (J Jᵀ + ρ I)⁻¹ J) x: along the constraints. multipliers() is then the y of least
  /// ‖x + Jᵀ y‖ for the x that came in.
  void project(Eigen::Matrix3Xd& x);

  /// y of the last step() or project().
  [[nodiscard]] const Eigen::VectorXd& multipliers() const { return multipliers_; }

  /// max |y| of the last step().
  [[nodiscard]] double largest_multiplier() const { return largest_entry(multipliers_); }

  [[nodiscard]] int factorizations() const { return factorizations_; }

 private:
  struct Coupling {
    int row, column;  ///< equations, row eliminated later
    BlockSlot slot;
  };

  const Patch* patch_ = nullptr;
  SparseCholesky cholesky_;
  std::vector<BlockSlot> diagonal_;
  std::vector<Coupling> couplings_;
  RowJacobian jacobian_;  ///< of the last factorization
  Eigen::VectorXd multipliers_;
  int factorizations_ = 0;
};

/// Newton steps until the residuals stop falling. Halves steps that do not help.
/// @param displacement 3 × free, in and out; left at the best point seen
/// @returns max |c| there, solver units
double correct_constraints(const Patch& patch, int max_passes, Eigen::Matrix3Xd& displacement,
                           int& factorizations);

}  // namespace planish
