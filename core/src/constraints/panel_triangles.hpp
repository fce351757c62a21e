// SPDX-License-Identifier: MIT
/// The triangles that a panel with a reflex corner is made of. While all of them keep their side,
/// its outline cannot cross itself. [SHP-1]
#pragma once

#include <array>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Of the triangulations of an outline without new points the one whose worst triangle is roundest.
/// Empty where there is none, so for an outline that crosses itself.
/// @param outline 3 × n, n ≥ 3, in the order of the corners
/// @param normal the outline goes round it counter-clockwise
/// @returns corners 0 … n − 1, ascending in each triangle
[[nodiscard]] std::vector<std::array<int, 3>> panel_triangles(const Positions& outline,
                                                              const Eigen::Vector3d& normal);

}  // namespace planish
