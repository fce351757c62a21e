// SPDX-License-Identifier: MIT
/// Which side of every panel is outside, and the normals there.
#pragma once

#include <optional>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Unit vectors, or zero where there is none.
struct OutsideNormals {
  Positions faces;     ///< 3 × n_faces; zero for a panel without area
  Positions vertices;  ///< 3 × n: of the area vectors around a vertex added up
};

/// Normals towards the outside, the side of most panels of each piece. nullopt for a surface with
/// one side only.
[[nodiscard]] std::optional<OutsideNormals> outside_normals(const Mesh& mesh);

}  // namespace planish
