// SPDX-License-Identifier: MIT
/// Samples made of tangent planes at the points of a triangular lattice: flat by construction.
#pragma once

#include "planish/mesh/mesh.hpp"

namespace planish {

/// A domed shell of flat hexagons, about size² points; every vertex lies on three tangent planes
/// of a convex surface. size ≥ 3.
[[nodiscard]] Mesh make_hex_shell(int size);

/// A saddle of flat hexagons and triangles (kagome), about size² points; every vertex lies on the
/// intersection of two tangent planes. size ≥ 3.
[[nodiscard]] Mesh make_trihex_shell(int size);

}  // namespace planish
