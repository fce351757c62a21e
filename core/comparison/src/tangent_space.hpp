// SPDX-License-Identifier: MIT
/// Quadratic problems over the tangent space of a patch, by one sparse factor.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "planish/problem/problem.hpp"

namespace planish::comparison {

/// [ω_f EᵀE + D + σI, Jᵀ; J, −ρI], quasi-definite: LDLᵀ exists in any order.
class TangentSpace {
 public:
  /// D holds the patch's square weights; J is taken at points + displacement.
  explicit TangentSpace(const Patch& patch);

  [[nodiscard]] bool usable() const { return factor_.info() == Eigen::Success; }
  /// argmin ½ tᵀ(ω_f EᵀE + D) t − tᵀ right, J t = 0. @param right 3·free
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// (ω_f EᵀE + D) t
  [[nodiscard]] Eigen::VectorXd stiffness(const Eigen::VectorXd& t) const { return hessian_ * t; }
  [[nodiscard]] const Eigen::SparseMatrix<double>& jacobian() const { return jacobian_; }

 private:
  Eigen::SparseMatrix<double> hessian_;   ///< 3·free × 3·free
  Eigen::SparseMatrix<double> jacobian_;  ///< equations × 3·free
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace planish::comparison
