// SPDX-License-Identifier: MIT
/// A panel laid flat: its outline in its own plane, and what is measured on it.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "planish/fabrication/panel_frame.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Corners in a plane, one a column, anticlockwise for a panel seen from outside.
using Outline = Eigen::Matrix2Xd;

/// A rectangle around an outline with one side along the outline's hull.
struct BoundingRectangle {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< where `along` and its left turn start
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();  ///< unit, along the width
  double width = 0.0, height = 0.0;                  ///< width ≥ height
};

struct FlatPanel {
  PanelFrame frame;
  Outline outline;                ///< 2 × k, corner 0 at the origin
  std::vector<double> off_plane;  ///< k, how far each corner is out of the plane, outside positive
};

/// @param x_side the side that x runs along, see panel_frame()
[[nodiscard]] FlatPanel flatten_panel(const Positions& positions, std::span<const int> face,
                                      int x_side);

/// Enclosed, positive where the corners run anticlockwise.
[[nodiscard]] double area_of(const Outline& outline);

/// Length of side k, from corner k to the next.
[[nodiscard]] double side_length(const Outline& outline, Eigen::Index side);

/// The angle inside the panel at corner k, radians, 0 … 2π.
[[nodiscard]] double interior_angle(const Outline& outline, Eigen::Index corner);

/// The smallest rectangle around `outline` by area. O(k²).
[[nodiscard]] BoundingRectangle bounding_rectangle(const Outline& outline);

/// `rectangle`, larger where `outline` stands out of it by more than `margin`.
[[nodiscard]] BoundingRectangle widened(const BoundingRectangle& rectangle, const Outline& outline,
                                        double margin);

/// Three corners that place a panel: corner 0, the farthest from it, and the farthest from the line
/// through both.
[[nodiscard]] std::vector<int> setting_out_corners(const Outline& outline);

}  // namespace planish
