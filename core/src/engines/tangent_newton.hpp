// SPDX-License-Identifier: MIT
/// A flat mesh that is fair as well, at a cost that grows with the mesh and no faster. [PRO-8]
///
/// Newton's method on the surface of the flat meshes. The tangent projection I − Jᵀ(JJᵀ)⁻¹J needs
/// the factor of one number a panel; conjugate gradients do the rest, so the 3n × 3n Hessian, whose
/// factor takes twelve seconds at 100,000 vertices, is never formed.
#pragma once

#include <Eigen/Core>

#include "engines/engine_outcome.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// Free vertices up to which other engines are as fast, and designs keep their bits with them.
inline constexpr int kMostFactored = 4096;

struct TangentNewtonOptions {
  int max_steps = 60;     ///< > 0, over both phases
  double settled = 1e-5;  ///< ‖P ∇F‖ of every vertex at the end, solver units, > 0
};

/// First onto the flat meshes: δ = −Jᵀ(JJᵀ)⁻¹c + the tangent step that the objective asks for. Then
/// along them: Steihaug's truncated conjugate gradients in a trust region, each step taken back
/// onto the constraints by chord steps (Absil, Mahony, Sepulchre 2008, chapter 7). With the
/// multipliers of least squares the model is of second order.
///
/// The state is never beyond the bound; kConverged: flat to 1e-9 mean edges and settled.
/// kSingularSystem: a vertex carries so many rows that JJᵀ would be dense, nothing was done.
/// @param patch fairness and square weights only; a shape weight of 0 leaves the bound out
/// @param displacement 3 × free, start (within the bound) and result
EngineOutcome descend_along_flat(const Patch& patch, const TangentNewtonOptions& options,
                                 const Progress& progress, Eigen::Matrix3Xd& displacement);

}  // namespace planish
