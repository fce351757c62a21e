// SPDX-License-Identifier: MIT
/// A flat mesh that is fair as well: (8) with its fairness term, and with the bound that keeps
/// every panel's shape. [PRO-6]
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engines/engine_outcome.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

struct FairFlatOptions {
  /// μ of the first stage, > 0; every stage multiplies it by 100 up to 1e6. Small: the mesh becomes
  /// flat gradually, and corners that come to their bound give way to others; costs more steps.
  double first_penalty = 1e6;
  int max_steps = 100;    ///< > 0, over all stages
  double settled = 1e-7;  ///< step at which the last stage ends, mean edges, > 0
};

/// Newton's method on the Lagrangian of [PB-1] without norm terms, with the exact curvature of rows
/// and bound. A factor serves as many steps as they halve: at 100 K vertices it costs forty times
/// what a step does. The state is never beyond the bound, whatever the status; kConverged: flat to
/// 1e-5 mean edges, and no step of the last stage leads further.
/// @param patch fairness and square weights only; a shape weight of 0 leaves the bound out
/// @param displacement 3 × free, start (within the bound) and result
EngineOutcome find_fair_flat(const Patch& patch, const FairFlatOptions& options,
                             const Progress& progress, Eigen::Matrix3Xd& displacement);

}  // namespace planish
