// SPDX-License-Identifier: MIT
/// What parts two panels: the plane with the widest gap, of those that two convex bodies are tested
/// with (separating axes). A panel counts as its convex hull. [KEE-4]
#pragma once

#include <Eigen/Core>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// The gap between two panels along a direction.
struct PanelGap {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of length 1, from the second to the first
  double lowest = 0.0;                                ///< of the first, along the normal
  double highest = 0.0;                               ///< of the second

  /// Negative: the direction does not part them.
  [[nodiscard]] double width() const { return lowest - highest; }
};

/// The widest gap along the normals of both panels, across their edges in their planes, and at
/// right angles to an edge of each. @param first, second 3 × corners
[[nodiscard]] PanelGap widest_gap(const Positions& first, const Positions& second);

/// A panel in the base and now; 3 × corners each.
struct PanelPath {
  Positions base, now;
};

/// Whether a plane is between them all the way from the base, straight on, so that they cannot have
/// gone through each other: one that moves as both do on average, or one for each part of the way.
/// @param clearance that is between them, too
[[nodiscard]] bool are_parted(const PanelPath& first, const PanelPath& second, double clearance);

}  // namespace planish
