// SPDX-License-Identifier: MIT
/// How far along a pull the handles of an edit get whose limits are bounds of the solve.
#pragma once

#include <functional>
#include <optional>

#include "planish/edit/pull_hold.hpp"

namespace planish {

/// An edit of a share of a pull, whose whole length is 1.
struct Arrival {
  double short_of = 0.0;  ///< by how much its handles stop short
  double over = 0.0;      ///< by how much more than they may; up to 0 the share is met
};

/// How far handles stop short, and beyond what `limit` allows, as shares of a pull.
/// @param way the longest way of a handle from the base to its target, model units
/// @param length of the whole pull, model units
[[nodiscard]] Arrival arrival_of(const PullLimit& limit, double way, double length,
                                 const EditStanding& edit);

/// Makes edits of shares of a pull.
struct Puller {
  std::function<std::optional<Arrival>(double share)> edit;  ///< nullopt: refused
  std::function<void()> keep;                                ///< keeps the last edit
  std::function<void()> back;                                ///< makes the one kept the last one
};

/// The share of a pull that the edit made last is of: the largest that was found to be met, or one
/// that is nearly met where handles get much further by it; where there is none, the smallest that
/// was tried. The end of the pull is tried first: where it is not met, what its handles reach says
/// about where others are. nullopt where an edit is refused.
/// @param tries edits beside the first
[[nodiscard]] std::optional<double> furthest(const Puller& puller, int tries);

}  // namespace planish
