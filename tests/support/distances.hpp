// SPDX-License-Identifier: MIT
/// Distances of points, segments and panels, measured without the core.
#pragma once

#include <Eigen/Core>
#include <array>

#include "planish/mesh/mesh.hpp"

namespace planish::testing {

using Segment = std::array<Eigen::Vector3d, 2>;

[[nodiscard]] double distance(const Eigen::Vector3d& p, const Segment& s);
[[nodiscard]] double distance(const Segment& s, const Segment& t);

/// From a point to the inside of a triangle; infinite where its foot is not there.
[[nodiscard]] double distance_inside(const Eigen::Vector3d& p, const Eigen::Matrix3d& triangle);

/// Between two convex flat panels (3 × corners); 0 where a side of one goes through the other.
[[nodiscard]] double panel_distance(const Positions& a, const Positions& b);

/// The least distance of a panel that was touched from one with which it shares no point, mean
/// edges of the base; infinite where none is near. Pairs are left out that were nearer than
/// `clearance` in the base. @param within of boxes around the panels, model units: farther ones are
/// not looked at
[[nodiscard]] double least_panel_distance(const Mesh& base, const Positions& after, double within,
                                          double clearance = 0.0);

}  // namespace planish::testing
