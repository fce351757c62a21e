// SPDX-License-Identifier: MIT
/// How a solve ended, and what it measured on the way. Returned, never printed.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "planish/problem/solve_cost.hpp"

namespace planish {

/// How a solve ended. In every case the positions that come with it are a valid design:
/// all constraints hold to the tolerance, unless `kToleranceNotMet` says otherwise.
enum class SolveStatus {
  kConverged,          ///< a stationary point of the problem, constraints met
  kIterationLimit,     ///< constraints met, the objective may still be lowered
  kNearestConfined,    ///< constraints met by another problem than (8): see ConfinedBecause
  kCancelled,          ///< the last state that meets the constraints
  kInfeasibleHandles,  ///< constraints met; the handles cannot reach their targets with them
  kToleranceNotMet,    ///< the best state found; some panels are above the tolerance
  kSingularSystem,     ///< the input, untouched: a factorization failed
  kNonFinite,          ///< the last finite state that meets the constraints
};

/// The status as one lower-case word for reports, for example "converged".
[[nodiscard]] std::string_view status_name(SolveStatus status);

/// One outer step of a solver.
struct IterationRecord {
  double objective = 0.0;        ///< mean-edge units, weights included
  double primal_residual = 0.0;  ///< constraint violation, mean-edge units
  double step = 0.0;             ///< longest way of a vertex in it, mean-edge units; not ALM
  double smoothing = 0.0;        ///< ε of [WSN-3], mean-edge units; 0 where nothing is smoothed
  double dual_residual = 0.0;    ///< [ALM-5]; ALM alone
  double penalty = 0.0;          ///< μ of [ALM-2]; ALM alone
};

/// What a progress callback asks for.
enum class Flow { kContinue, kStop };

/// Called after every outer step; returning kStop ends the solve with kCancelled and the last
/// valid state. Must not call back into the solver. May be empty.
using Progress = std::function<Flow(const IterationRecord&)>;

/// The terms of an objective, each with its weight, in mean-edge units.
struct ObjectiveTerms {
  double handle = 0.0;
  double sparsity = 0.0;
  double fairness = 0.0;
  [[nodiscard]] double total() const { return handle + sparsity + fairness; }
};

/// How far a result is from a first-order point of the stated problem, over the whole mesh. [OPT-1]
struct Optimality {
  double stationarity = 0.0;  ///< largest ‖∇F + Jᵀλ‖ of a moved vertex, in units of ω_s/2
  double outside = 0.0;  ///< largest ‖∇F + Jᵀλ‖ of a vertex at rest over ω_s/2, less 1; ≥ 0
  /// Largest share of its range by which a stated limit or a keep-out that presses is off its
  /// bound, or another is beyond it. [LIM-2]
  double complementarity = 0.0;
  int certified_vertices = 0;  ///< whose conditions were evaluated; no row reaches the others

  /// What "converged" means.
  [[nodiscard]] bool met() const {
    return stationarity <= 1e-4 && outside <= 1e-4 && complementarity <= 1e-4;
  }
};

/// How far a mesh is from one kind of constraint that was kept, before and after.
struct KindViolation {
  std::string_view kind;    ///< its name, for example "circular"
  std::string_view unit;    ///< of the measure, for example "deg"
  double before_max = 0.0;  ///< worst element
  double after_max = 0.0;
};

/// A stated limit and the panels that it holds back; "shape": those that a variation would spoil;
/// "keep-out": the points.
struct BoundStanding {
  std::string_view name;     ///< for example "fold"
  std::vector<int> binding;  ///< faces, or vertices, ascending
};

struct SolveReport {
  SolveStatus status = SolveStatus::kIterationLimit;
  ObjectiveTerms objective;
  double planarity_before = 0.0;          ///< worst panel before, mm/m
  double planarity_after = 0.0;           ///< worst panel after, mm/m
  std::vector<KindViolation> violations;  ///< every kept kind, planarity first
  std::vector<BoundStanding> bounds;      ///< every stated limit that rows hang on
  int moved_vertices = 0;                 ///< coordinates not bit-identical to the input's
  double max_displacement = 0.0;          ///< model units
  double handle_error = 0.0;  ///< largest distance of a handle from its target, model units
  SolveCost cost;
  double setup_seconds = 0.0;
  double solve_seconds = 0.0;
  std::vector<IterationRecord> records;
  std::optional<Optimality> optimality;  ///< of the positions; absent where none was computed

  /// Whether the positions may be shown to a user as an exact result.
  [[nodiscard]] bool usable() const { return status <= SolveStatus::kInfeasibleHandles; }
};

}  // namespace planish
