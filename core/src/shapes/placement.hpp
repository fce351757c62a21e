// SPDX-License-Identifier: MIT
/// Where a sample stands and how large it is.
#pragma once

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Scales `mesh` to mean edge 1 and moves it so that it stands on z = 0 over the origin.
void place_with_unit_edges(Mesh& mesh);

}  // namespace planish
