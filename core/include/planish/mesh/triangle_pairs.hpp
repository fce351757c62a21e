// SPDX-License-Identifier: MIT
/// The quads of a mesh that was written as triangles.
#pragma once

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Triangles joined two by two over an edge; all vertices and every other face stay, a quad stands
/// where its first triangle stood and begins with the same corner. Groups keep their faces: only
/// triangles of one group join.
///
/// Where the faces 0 and 1, 2 and 3, … all make convex quads, as programs write them, those are the
/// pairs. Otherwise the pair whose corners are nearest to right angles comes first, and so on;
/// quads with a corner beyond 30° to 150° or a fold of more than 60° along the diagonal are none.
/// O(n log n); the same on every machine.
/// @param mesh must have passed check_mesh()
[[nodiscard]] Mesh join_triangles(const Mesh& mesh);

}  // namespace planish
