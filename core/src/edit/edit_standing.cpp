// SPDX-License-Identifier: MIT
#include "planish/edit/edit_standing.hpp"

#include <algorithm>

#include "planish/edit/fair_limits.hpp"

namespace planish {

bool is_bound(const SolveReport& report) {
  return std::any_of(report.bounds.begin(), report.bounds.end(),
                     [](const BoundStanding& bound) { return !bound.binding.empty(); });
}

bool is_stuck(const EditStanding& edit) {
  return edit.status == SolveStatus::kInfeasibleHandles ||
         (edit.status == SolveStatus::kIterationLimit && edit.moved_vertices == 0);
}

bool suffices(const EditStanding& edit, double way, double most) {
  const bool arrives = !is_stuck(edit) && !edit.is_bound && edit.handle_error <= most * way;
  return arrives && edit.fold_growth <= kFairFolds.front();
}

}  // namespace planish
