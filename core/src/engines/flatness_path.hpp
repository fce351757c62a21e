// SPDX-License-Identifier: MIT
/// The meshes between one that is not flat and a flat one. [PRO-7]
#pragma once

#include <Eigen/Core>

#include "engines/engine_outcome.hpp"
#include "engines/patch_newton.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// Minima of F + μ/2 ‖c‖² + t Σ B(s), as far along the way to a flat mesh as μ is stiff. None of
/// them is beyond the bound on the panels' shape.
class FlatnessPath {
 public:
  /// @param patch fairness and square weights only; must outlive this
  explicit FlatnessPath(const Patch& patch);

  /// Goes on with the patch after its tracks changed.
  void attach(const Patch& patch);

  /// @param penalty μ > 0
  /// @param from 3 × free, within the bound; best the minimum of a μ nearby
  /// @return 3 × free
  [[nodiscard]] Eigen::Matrix3Xd settle(double penalty, const Eigen::Matrix3Xd& from,
                                        const Progress& progress);

  /// The outcome of all settles so far; kCancelled after one that was.
  [[nodiscard]] const EngineOutcome& outcome() const { return outcome_; }

 private:
  PatchNewton solver_;
  EngineOutcome outcome_;
};

}  // namespace planish
