// SPDX-License-Identifier: MIT
/// What an offset became, measured on its positions.
#pragma once

#include <vector>

#include "offset/edge_directions.hpp"
#include "offset/panel_sides.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/offset/mesh_offset.hpp"

namespace planish {

/// Measures all of the report for offset.positions but its kind, which must be set.
void measure_offset(const Mesh& mesh, const std::vector<DirectedEdge>& edges,
                    const OutsideNormals& normals, double distance, MeshOffset& offset);

}  // namespace planish
