// SPDX-License-Identifier: MIT
/// What makes a mesh conical, measured without the product's code.
#pragma once

#include "planish/mesh.hpp"

namespace planish::testing {

/// Degrees: worst |ω₁ − ω₂ + ω₃ − ω₄| over the inner vertices of valence 4; their angles are
/// collected face by face, opposite ones being those of faces that share the vertex alone.
[[nodiscard]] double worst_cone_defect(const Mesh& mesh, const Positions& positions);

}  // namespace planish::testing
