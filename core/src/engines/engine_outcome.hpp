// SPDX-License-Identifier: MIT
/// How a run of an engine ended. The state itself lies where its caller keeps it.
#pragma once

#include <vector>

#include "planish/problem/solve_report.hpp"

namespace planish {

struct EngineOutcome {
  SolveStatus status = SolveStatus::kIterationLimit;
  double objective =
      0.0;  ///< of the state reached, before it is made exact; [PB-1] for (3) and (8)
  SolveCost cost;
  std::vector<IterationRecord> records;  ///< one a step, or one a dual update
};

}  // namespace planish
