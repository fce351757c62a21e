// SPDX-License-Identifier: MIT
#include "planish/problem/solve_report.hpp"

namespace planish {

std::string_view status_name(SolveStatus status) {
  switch (status) {
    case SolveStatus::kConverged:
      return "converged";
    case SolveStatus::kIterationLimit:
      return "iteration_limit";
    case SolveStatus::kNearestConfined:
      return "nearest_confined";
    case SolveStatus::kCancelled:
      return "cancelled";
    case SolveStatus::kInfeasibleHandles:
      return "infeasible_handles";
    case SolveStatus::kToleranceNotMet:
      return "tolerance_not_met";
    case SolveStatus::kSingularSystem:
      return "singular_system";
    case SolveStatus::kNonFinite:
      return "non_finite";
  }
  return "unknown";
}

}  // namespace planish
