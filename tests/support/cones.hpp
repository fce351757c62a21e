// SPDX-License-Identifier: MIT
/// What makes a mesh conical, measured without the product's code.
#pragma once

#include "planish/mesh/mesh.hpp"

namespace planish::testing {

/// Degrees: worst |ω₁ − ω₂ + ω₃ − ω₄| over the inner vertices of valence 4; their angles are
/// collected face by face, opposite ones being those of faces that share the vertex alone.
[[nodiscard]] double worst_cone_defect(const Mesh& mesh, const Positions& positions);

/// Degrees: by how much the faces around `vertex` differ in their angle to one axis, that which
/// suits their area vectors best.
[[nodiscard]] double axis_spread(const Mesh& mesh, const Positions& positions, int vertex);

/// Quads around vertex 0 of this valence, `rings` of them, on a paraboloid that is steeper along x.
[[nodiscard]] Mesh sectors(int valence, int rings);

}  // namespace planish::testing
