// SPDX-License-Identifier: MIT
/// The axis that a node's arms are set out about.
#pragma once

#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Unit vector: the line of the point that the planes around a vertex keep when all of them move
/// outwards alike; where they keep none, or leave it open, the sum of the area vectors of the
/// panels around it; z where that is 0. [OFF-4]
/// @param positions 3 × n, of the vertices of `mesh`
[[nodiscard]] Eigen::Vector3d node_axis(const Mesh& mesh, const Positions& positions,
                                        const Adjacency& adjacency, int vertex);

}  // namespace planish
