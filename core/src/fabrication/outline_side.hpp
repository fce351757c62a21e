// SPDX-License-Identifier: MIT
/// The sides of an outline, and how near they come to each other.
#pragma once

#include <vector>

#include "planish/fabrication/flat_panel.hpp"

namespace planish {

/// A side between two corners; `along`: its direction, of length 1.
struct OutlineSide {
  Eigen::Vector2d from, to, along;
  double length = 0.0;
  int number = 0;
};

/// The turn between two directions or vectors, positive where `b` points to the left of `a`.
[[nodiscard]] double turn_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// A quarter turn to the left.
[[nodiscard]] Eigen::Vector2d left_of(const Eigen::Vector2d& along);

/// The sides that have a length, numbered from corner 0.
[[nodiscard]] std::vector<OutlineSide> sides_of(const Outline& outline);

/// The distance from `p` to the nearest point of the side.
[[nodiscard]] double distance_to(const OutlineSide& side, const Eigen::Vector2d& p);

/// Whether two sides cross between their ends.
[[nodiscard]] bool has_crossing(const std::vector<OutlineSide>& sides);

/// Whether no two sides come nearer to each other than `clearance`, but for where they meet.
[[nodiscard]] bool is_simple(const std::vector<OutlineSide>& sides, double clearance);

}  // namespace planish
