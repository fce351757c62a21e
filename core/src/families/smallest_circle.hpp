// SPDX-License-Identifier: MIT
/// The smallest circle around points.
#pragma once

#include <Eigen/Core>

namespace planish {

/// The centre of the smallest circle around points, to rounding. O(points × a few). @param points
/// one a column, one at least
[[nodiscard]] Eigen::Vector2d smallest_circle_centre(const Eigen::Matrix2Xd& points);

}  // namespace planish
