// SPDX-License-Identifier: MIT
/// The edit of a session's base with the limits that cost its handles nothing.
#include <optional>
#include <utility>

#include "planish/measures/panel_health.hpp"
#include "session.hpp"

namespace planish {

Refusal Session::edit_fairly(EditMode mode, const EditTargets& targets, double budget_seconds,
                             const FairSearch& search) {
  fair_found_.clear();
  if (Refusal refusal = edit(mode, targets, budget_seconds)) return refusal;
  const HandleEditOptions asked = options_;
  Refusal last;
  const LimitedEdit limited =
      [&](const std::vector<StatedLimit>& limits) -> std::optional<FairStanding> {
    HandleEditOptions options = asked;
    options.bounds.insert(options.bounds.end(), limits.begin(), limits.end());
    last = set_options(std::move(options));
    if (!last) last = edit(mode, targets, budget_seconds);
    if (last) return std::nullopt;
    return fair_standing(search.corners);
  };
  fair_found_ = find_fair_limits(fair_standing(search.corners), search, limited);
  return last;
}

/// Slivers are told of what was opened, as the page does.
FairStanding Session::fair_standing(bool with_slivers) const {
  const ShapeReport& shown = shape_report_;
  const bool is_planarised = before_planarising_.cols() > 0;
  const Positions& opened = is_planarised ? before_planarising_ : base_.positions;
  return {.status = shown.solve.status,
          .moved_vertices = shown.moved_vertices,
          .handle_error = shown.handle_error,
          .fold_growth = shown.fold_growth,
          .slivers = with_slivers ? count_new_slivers(base_, opened, current_) : 0};
}

}  // namespace planish
