// SPDX-License-Identifier: MIT
/// The nearest point of the constraint manifold, min ½‖t‖² s.t. c(p + t) = 0. [PRO-4]
#pragma once

#include <Eigen/Core>

#include "engines/engine_outcome.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

struct NearestFlatOptions {
  int max_steps = 400;
  /// Step, as a share of ‖t‖, below which t counts as the nearest point: ‖t‖² is then least to
  /// about the square of it. In (0, 1); smaller: more steps, and fewer digits left to rounding.
  double settled = 5e-5;
};

/// Sequential quadratic programming with the identity as Hessian: each step is the minimum-norm
/// solution t⁺ = Jᵀ(J Jᵀ + ρI)⁻¹(J t − c), one scalar factor per equation, so 100 K panels are a
/// matter of tenths of a second. Anderson mixing shortens the linearly convergent tail; steps that
/// stop shrinking are judged by ½‖t‖² + σ‖c‖₁ instead. At the end t goes onto the constraints to
/// rounding.
/// @param patch usually the whole mesh
/// @param displacement 3 × free, start and result
EngineOutcome find_nearest_flat(const Patch& patch, const NearestFlatOptions& options,
                                const Progress& progress, Eigen::Matrix3Xd& displacement);

}  // namespace planish
