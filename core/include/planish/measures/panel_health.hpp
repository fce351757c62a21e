// SPDX-License-Identifier: MIT
/// Whether a panel can be made: its outline, its shortest edge, its smallest angle.
#pragma once

#include <span>

#include "planish/mesh/area_vector.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

enum class PanelOutline {
  kConvex,
  kConcave,       ///< some corner turns the other way
  kSelfCrossing,  ///< two edges cross, as in a bow-tie; planar hexagons in saddles become this
};

struct PanelHealth {
  PanelOutline outline = PanelOutline::kConvex;
  double shortest_edge = 0.0;   ///< model units
  double smallest_angle = 0.0;  ///< inside the panel, degrees, 0 … 360
};

/// Degrees: a panel with a sharper corner is a sliver and breaks there.
inline constexpr double kSliverAngle = 15.0;

/// What became of a panel since `before`; the worst of it, most serious first.
enum class PanelDamage {
  kNone,          ///< including what was there before
  kSelfCrossing,  ///< two edges cross that did not
  kTurnedOver,    ///< its normal points the other way
  kCollapsed,     ///< an edge or the whole panel is thinner than a thousandth of its longest edge
  kConcave,       ///< it was convex; a corner that was straight may have turned by a degree
};

/// Seen along the panel's own normal; `positions` is 3 × n of the whole mesh. O(k²) for a concave
/// panel with k corners, and one with more than 256 is not tested for crossings.
[[nodiscard]] PanelHealth panel_health(const Positions& positions, std::span<const int> face);

/// `before` and `after` are 3 × n of the whole mesh.
[[nodiscard]] PanelDamage panel_damage(const Positions& before, const Positions& after,
                                       std::span<const int> face);

/// Whether a panel is a sliver that was none before, whatever else became of it.
[[nodiscard]] bool became_sliver(const Positions& before, const Positions& after,
                                 std::span<const int> face);

/// How many panels became slivers and nothing worse. O(n).
[[nodiscard]] int count_new_slivers(const Mesh& mesh, const Positions& before,
                                    const Positions& after);

}  // namespace planish
