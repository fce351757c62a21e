// SPDX-License-Identifier: MIT
/// (7) in the split form of Appendix B: y = t, q = t, m = t and J t = 0. [SUB-6]
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>

#include "engines/patch_system.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// The Splitting of run_alm() for one basis vector; see that function for what each step is.
class SubspaceSplitting {
 public:
  /// @param patch undisplaced, at p⁺; norm weights C^i, square weights β_h; must outlive this
  /// @param basis 3·free × k, orthonormal
  /// @param start 3 × free, unit
  /// @param executor of the solves, must outlive this; the bits are the same
  SubspaceSplitting(const Patch& patch, const Eigen::MatrixXd& basis, const Eigen::Matrix3Xd& start,
                    Executor* executor = nullptr);

  [[nodiscard]] bool set_penalty(double penalty);
  void update_auxiliaries();
  void update_primal();
  [[nodiscard]] double dual_residual() const { return dual_residual_; }
  [[nodiscard]] double update_multipliers();
  [[nodiscard]] double objective() const;

  [[nodiscard]] const Eigen::Matrix3Xd& vector() const { return t_; }

 private:
  const Patch& patch_;
  const Eigen::MatrixXd& basis_;
  Executor* executor_;
  std::map<double, std::unique_ptr<PatchSystem>> systems_;  ///< by penalty, each made once
  PatchSystem* system_ = nullptr;
  Patch quadratic_;  ///< the patch without its norm terms
  Eigen::Matrix3Xd t_, y_, q_, m_, y_multiplier_, q_multiplier_, m_multiplier_;
  Eigen::VectorXd tangent_multiplier_;  ///< λᵗ of J t = 0
  double penalty_ = 0.0;
  double rows_ = 1.0;
  double dual_residual_ = 0.0;
};

}  // namespace planish
