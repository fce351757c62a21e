// SPDX-License-Identifier: MIT
/// What the rules of a drag and of fair limits ask of an edit that was made.
#pragma once

#include "planish/problem/solve_report.hpp"

namespace planish {

struct EditStanding {
  SolveStatus status = SolveStatus::kConverged;
  int moved_vertices = 0;
  double handle_error = 0.0;  ///< model units
  double fold_growth = 0.0;   ///< degrees, see largest_fold_growth()
  bool is_bound = false;      ///< a panel or a point is at a limit
  int slivers = 0;            ///< see count_new_slivers(); where they are asked for
};

/// Whether a limit holds something back.
[[nodiscard]] bool is_bound(const SolveReport& report);

/// Whether an edit found no way to move, or only a part of the way.
[[nodiscard]] bool is_stuck(const EditStanding& edit);

/// Share of its way: as near to its target a handle meets it.
inline constexpr double kMet = 0.05;
/// Share of its way: a handle that stops short by less is not said to. Soft handles stop short by a
/// hundredth, raw weights by a tenth.
inline constexpr double kNoticeable = 0.15;

/// Whether more panels need not follow: handles arrive, nothing is at a limit, no fold gets unfair.
/// @param way of the handle that goes furthest; model units
/// @param most the share of it by which handles may stop short
[[nodiscard]] bool suffices(const EditStanding& edit, double way, double most);

}  // namespace planish
