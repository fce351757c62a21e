// SPDX-License-Identifier: MIT
/// How large a polygon is and which way it faces.
#pragma once

#include <Eigen/Core>
#include <span>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Twice the area, along the normal (Newell); relative to a corner, as far from the origin sums
/// lose digits. `positions` is 3 × n of the whole mesh.
[[nodiscard]] Eigen::Vector3d area_vector(const Positions& positions, std::span<const int> face);

}  // namespace planish
