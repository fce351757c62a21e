// SPDX-License-Identifier: MIT
/// Panels turned so that neighbours have their outside on one side.
#pragma once

#include "planish/mesh/mesh.hpp"

namespace planish {

/// A mesh with some of its panels turned over; each begins with the same corner as before.
struct Oriented {
  Mesh mesh;
  int turned = 0;
};

/// Turns panels until neighbours agree, part by part over common edges: the outside of a closed
/// part comes out, an open one's up, and one that faces neither way keeps that of most of its area.
/// A part that has one side only (Möbius) stays as it is. O(n log n).
/// @param mesh must have passed check_mesh()
[[nodiscard]] Oriented oriented(Mesh mesh);

}  // namespace planish
