// SPDX-License-Identifier: MIT
/// Of all places that were measured, those where the shape itself can change most.
#pragma once

#include <vector>

#include "planish/mesh/adjacency.hpp"
#include "planish/mobility/mobility_meter.hpp"

namespace planish {

/// Edges between the vertices of two places, at least: a move within the default reach leaves the
/// other place alone, or nearly.
inline constexpr int kPlacesApart = 4;

/// Rows up or down, the farthest first, of equal ones that with the fewest panels to be made again
/// and then with the softest fold; none within kPlacesApart edges of one before it, none that does
/// not move. Moves along the surface are left out: they slide points within their panels.
/// @param rows of vertices of the mesh, in any order
/// @param count at most so many
[[nodiscard]] std::vector<MobilityRow> best_places(const Adjacency& adjacency,
                                                   std::vector<MobilityRow> rows, int count);

}  // namespace planish
