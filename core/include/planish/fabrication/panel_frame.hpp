// SPDX-License-Identifier: MIT
/// A panel's own coordinates: where it is cut, drawn and measured.
#pragma once

#include <Eigen/Core>
#include <span>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// A right-handed frame on a panel; `normal` points outside, as the mesh is oriented.
struct PanelFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   ///< corner 0, model units
  Eigen::Vector3d x = Eigen::Vector3d::UnitX();       ///< unit, along one edge
  Eigen::Vector3d y = Eigen::Vector3d::UnitY();       ///< unit, normal × x
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, of the best-fit plane

  /// Coordinates of a point of the model: x and y in the panel, z out of it.
  [[nodiscard]] Eigen::Vector3d to_panel(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d d = point - origin;
    return {x.dot(d), y.dot(d), normal.dot(d)};
  }
  /// The inverse of to_panel().
  [[nodiscard]] Eigen::Vector3d to_model(const Eigen::Vector3d& p) const {
    return origin + p.x() * x + p.y() * y + p.z() * normal;
  }
};

/// Unit normal of the best-fit plane of `face`, on the side from which its corners run
/// anticlockwise; some unit vector for a panel without area. `positions` is 3 × n of the whole
/// mesh.
[[nodiscard]] Eigen::Vector3d panel_normal(const Positions& positions, std::span<const int> face);

/// The side of `face` (side k runs from corner k to the next) that is longest; the first of those
/// that are equal up to rounding, so that a regular panel does not turn by chance.
[[nodiscard]] int longest_side(const Positions& positions, std::span<const int> face);

/// The frame of `face` with x along `side`, which must not have length 0 where any side has not.
[[nodiscard]] PanelFrame panel_frame(const Positions& positions, std::span<const int> face,
                                     int side);

}  // namespace planish
