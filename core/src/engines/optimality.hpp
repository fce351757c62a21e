// SPDX-License-Identifier: MIT
/// The first-order conditions of [PB-1], measured: what a certificate says. [OPT-1]
#pragma once

#include <Eigen/Core>
#include <optional>

#include "planish/problem/problem.hpp"
#include "planish/problem/solve_report.hpp"

namespace planish {

/// Stationarity at the free vertices that moved, and the bound ‖pull‖ ≤ w/2 at those at rest: that
/// have moved by no more than `rest`. Vertices without a norm weight count as moved.
/// @param patch an open one [OPT-2]: then all vertices outside it are certified with λ = 0
/// @param displacement 3 × free
/// @param pulls ∇F + Jᵀλ at `displacement` without the norms' part, 3 × free
[[nodiscard]] Optimality optimality_of(const Patch& patch, const Eigen::Matrix3Xd& displacement,
                                       const Eigen::Matrix3Xd& pulls, double rest);

/// Optimality of a problem without norm terms, with the multipliers that fit best; nullopt where
/// one vertex has too many rows. [OPT-3]
[[nodiscard]] std::optional<Optimality> fitted_optimality(const Patch& patch,
                                                          const Eigen::Matrix3Xd& displacement);

}  // namespace planish
