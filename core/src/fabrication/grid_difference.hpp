// SPDX-License-Identifier: MIT
/// Polygons less polygons on a grid of whole numbers: which parts are left, and in what order their
/// sides follow each other.
#pragma once

#include <vector>

#include "planish/fabrication/flat_panel.hpp"

namespace planish {

/// The parts of `outline` that no polygon of `taken` covers, anticlockwise, sides rounded to the
/// grid of 1 / `scale`. Boost.Polygon, exact up to that rounding (decision 50).
/// @param scale times any coordinate it is below 2³¹
[[nodiscard]] std::vector<Outline> grid_difference(const Outline& outline,
                                                   const std::vector<Outline>& taken, double scale);

}  // namespace planish
