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
  const auto shown = [&] {
    EditStanding edit = standing();
    if (search.corners) edit.slivers = slivers();
    return edit;
  };
  Refusal last;
  const LimitedEdit limited =
      [&](const std::vector<StatedLimit>& limits) -> std::optional<EditStanding> {
    HandleEditOptions options = asked;
    options.bounds.insert(options.bounds.end(), limits.begin(), limits.end());
    last = set_options(std::move(options));
    if (!last) last = edit(mode, targets, budget_seconds);
    if (last) return std::nullopt;
    return shown();
  };
  fair_found_ = find_fair_limits(shown(), search, limited);
  return last;
}

/// Told of what was opened, as the page does.
int Session::slivers() const {
  const bool is_planarised = before_planarising_.cols() > 0;
  const Positions& opened = is_planarised ? before_planarising_ : base_.positions;
  return count_new_slivers(base_, opened, current_);
}

}  // namespace planish
