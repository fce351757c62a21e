// SPDX-License-Identifier: MIT
/// Engine 1, the paper's: augmented Lagrangian with alternating minimisation (Sec. 3, Fig. 7).
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engines/displacement_field.hpp"
#include "engines/engine_outcome.hpp"
#include "planish/numeric/executor.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// Tuning of run_alm(). All values are pure numbers: lengths are in mean edges.
struct AlmOptions {
  double penalty = 10.0;         ///< first μ > 0. Larger: stiffer, less local first steps [ALM-2]
  double penalty_growth = 1.5;   ///< factor > 1 of a penalty update [ALM-4]
  double largest_penalty = 1e4;  ///< bound of μ; past it μ stays [ALM-4]
  int max_inner = 30;            ///< l_max ≥ 1 steps of alternating minimisation [ALM-3]
  double primal_tolerance = 1e-5;  ///< ε_p on ‖h‖ / √(number of rows), > 0 [ALM-5]
  double dual_tolerance = 3e-4;    ///< ε_d on ‖r‖ / √(number of rows), > 0 [ALM-5]
  int max_outer = 400;             ///< dual updates ≥ 0; 0 returns the start point
  Executor* executor = nullptr;    ///< of the parallel steps; null: the caller's thread [ALM-7]
};

/// What one pass of alternating minimisation measured.
struct AlmResiduals {
  double primal = 0.0;  ///< ‖h‖ = ‖x − A d − b‖ / √(number of rows)
  double dual = 0.0;    ///< ‖r‖ = ‖μ A (d − d_previous)‖ / √(number of rows)
};

/// The only augmented Lagrangian loop: (3), (7) and (8) differ in their Splitting alone. It owns
/// the order of the steps of Fig. 7; the splitting owns d, x and λ. [ALM-1]
///
/// A Splitting has
///   bool set_penalty(μ)           factor for this μ, at most once each; false: singular
///   void update_auxiliaries()     x ← argmin L̂(d, x)                          [ALM-3]
///   void update_primal()          d ← argmin L̂(d, x); remembers d − d_previous [ALM-3]
///   double dual_residual()        of the last update_primal()
///   double update_multipliers()   λ ← λ + μ h; returns the primal residual      [ALM-1]
///   double objective()
template <class Splitting>
[[nodiscard]] EngineOutcome run_alm(Splitting& splitting, const AlmOptions& options,
                                    const Progress& progress) {
  EngineOutcome run;
  const auto ended = [&](SolveStatus status) {
    run.status = status;
    return std::move(run);
  };
  double penalty = options.penalty;
  AlmResiduals previous{0.0, 0.0};
  if (!splitting.set_penalty(penalty)) return ended(SolveStatus::kSingularSystem);
  for (int outer = 0; outer < options.max_outer; ++outer) {
    AlmResiduals now;
    for (int inner = 0; inner < options.max_inner; ++inner) {
      splitting.update_auxiliaries();
      splitting.update_primal();
      ++run.cost.steps;
      now.dual = splitting.dual_residual();
      if (now.dual <= options.dual_tolerance) break;
    }
    now.primal = splitting.update_multipliers();
    run.objective = splitting.objective();
    run.records.push_back({.objective = run.objective,
                           .primal_residual = now.primal,
                           .dual_residual = now.dual,
                           .penalty = penalty});
    if (!std::isfinite(now.primal + now.dual)) return ended(SolveStatus::kNonFinite);
    if (now.primal <= options.primal_tolerance && now.dual <= options.dual_tolerance) {
      return ended(SolveStatus::kConverged);
    }
    if (progress && progress(run.records.back()) == Flow::kStop) {
      return ended(SolveStatus::kCancelled);
    }
    // Sec. 3.3: only when ‖h‖ falls too slowly against ‖r̂‖, and never past the bound. [ALM-4]
    const bool slow = outer > 0 && now.primal > options.primal_tolerance &&
                      now.primal * previous.dual > previous.primal * now.dual;
    if (slow && penalty * options.penalty_growth <= options.largest_penalty) {
      penalty *= options.penalty_growth;
      if (!splitting.set_penalty(penalty)) return ended(SolveStatus::kSingularSystem);
    }
    previous = now;
  }
  return run;
}

/// (3) or (8) by the reference engine: the whole mesh, then the rest of the problem on the support.
/// @param field d, the result
/// @param support the vertices with y_i ≠ 0, and fixed handles; ascending
[[nodiscard]] EngineOutcome solve_edit_by_alm(const EditProblem& problem, const AlmOptions& options,
                                              DisplacementField& field, std::vector<int>& support,
                                              const Progress& progress);

}  // namespace planish
