// SPDX-License-Identifier: MIT
/// Meshes that check_mesh() accepts and a solver may stumble over.
#pragma once

#include <string>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish::testing {

struct NamedMesh {
  std::string name;
  Mesh mesh;
  int handle = 0;  ///< a vertex worth pulling
};

/// Coincident vertices, panels without area, self-crossing and folded ones, valence-2 vertices,
/// triangles only, a single panel, closed, in pieces, one-sided, tiny, huge, far away, and one
/// panel with 10,000 vertices.
[[nodiscard]] std::vector<NamedMesh> hostile_meshes();

}  // namespace planish::testing
