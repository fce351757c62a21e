// SPDX-License-Identifier: MIT
/// How far an edit takes points off the surface of the base, and how far along it: what changes
/// the shape, and what only shifts the joints.
#pragma once

#include <span>
#include <vector>

#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// What became of one point, in the unit of the positions.
struct PointMotion {
  double shape = 0.0;  ///< distance from the old surface, positive on its outside
  double slide = 0.0;  ///< across the normal at the old point; ≥ 0
};

/// The largest of many points; all ≥ 0.
struct MotionRange {
  double raised = 0.0, lowered = 0.0;  ///< outside and inside of the old surface
  double slide = 0.0;
  /// The largest distance from the old surface, on whichever side.
  [[nodiscard]] double shape() const { return raised > lowered ? raised : lowered; }
};

/// The motion of each of `moved`, in their order.
///
/// The old surface is the panels of `base`; its outside is the side from which their corners run
/// counter-clockwise. The foot of a point that is now at p is where this walk ends: from the panels
/// around the point to the one nearest to p, and on to the nearest of those that share a corner
/// with it, while that is nearer. So a surface that passes by again is not jumped onto.
///
/// Shape is ±‖p − foot‖, with the sign of N·(p − foot). N is the normal at the foot: of its panel;
/// on an edge or a corner the mean of those around it, weighted by their angles there. Where the
/// foot is on the border, the surface goes on straight, at right angles to N: shape is N·(p −
/// foot). Slide is ‖d − (n·d) n‖, d the move and n the mean normal of the panels around the old
/// point, along which handles are dragged: what a SlideLimit bounds. Hence, up to rounding (and for
/// p over a panel that is not flat, up to its gap), |shape| ≤ move and slide ≤ move. [MET-5]
///
/// A point of no panel has its whole move as its slide. Costs what the panels are that the walks
/// pass, and their neighbours.
/// @param after 3 × n of the whole mesh
[[nodiscard]] std::vector<PointMotion> motions(const Mesh& base, const Adjacency& adjacency,
                                               std::span<const int> moved, const Positions& after);

[[nodiscard]] MotionRange range_of(std::span<const PointMotion> motions);

}  // namespace planish
