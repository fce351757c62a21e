// SPDX-License-Identifier: MIT
#include "planish/solve_report.hpp"

namespace planish {

std::string_view status_name(SolveStatus status) {
  switch (status) {
    case SolveStatus::kConverged:
      return "converged";
    case SolveStatus::kIterationLimit:
      return "iteration limit";
    case SolveStatus::kCancelled:
      return "cancelled";
    case SolveStatus::kInfeasibleHandles:
      return "infeasible handles";
    case SolveStatus::kToleranceNotMet:
      return "tolerance not met";
    case SolveStatus::kSingularSystem:
      return "singular system";
    case SolveStatus::kNonFinite:
      return "non-finite";
  }
  return "unknown";
}

}  // namespace planish
