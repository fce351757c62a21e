// SPDX-License-Identifier: MIT
/// The nearest point of the constraint manifold, min ½‖t‖² s.t. c(p + t) = 0. [PRO-4]
#pragma once

#include <Eigen/Core>

#include "planish/problem.hpp"
#include "planish/solve_report.hpp"

namespace planish {

struct NearestFlatOutcome {
  SolveStatus status = SolveStatus::kIterationLimit;
  int steps = 0, factorizations = 0;
  std::vector<IterationRecord> records;
};

/// Sequential quadratic programming with the identity as Hessian: each step is the minimum-norm
/// solution t⁺ = Jᵀ(J Jᵀ + ρI)⁻¹(J t − c), one scalar factor per equation, so 100 K panels are a
/// matter of tenths of a second. Anderson mixing shortens the linearly convergent tail; steps that
/// stop shrinking are judged by ½‖t‖² + σ‖c‖₁ instead. Ends when steps are below 1e-3 of ‖t‖, where
/// ‖t‖² is least to about 1e-6 of itself, and then goes onto the constraints to rounding.
/// @param patch usually the whole mesh
/// @param displacement 3 × free, start and result
NearestFlatOutcome find_nearest_flat(const Patch& patch, int max_steps, const Progress& progress,
                                     Eigen::Matrix3Xd& displacement);

}  // namespace planish
