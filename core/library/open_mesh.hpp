// SPDX-License-Identifier: MIT
/// A mesh as programs hold it: checked, with what a design must know of its origin.
#pragma once

#include <string>
#include <vector>

#include "planish/design/design.hpp"
#include "planish/mesh/mesh.hpp"
#include "request.hpp"

namespace planish::library {

using namespace workflow;  // its names are the library's

/// Never changes once it is made.
struct OpenMesh {
  Mesh mesh;
  DesignSource source;
  std::vector<std::string> warnings;
  std::string name;  ///< for messages
};

/// Throws RequestError, as all of these do, naming what is wrong.
/// @param positions 3 × n  @param offsets f + 1  @param corners offsets[f] vertex indices
[[nodiscard]] OpenMesh mesh_of_lists(Positions positions, std::vector<int> offsets,
                                     std::vector<int> corners);

/// The mesh at `path` (.obj .off .ply .glb), or "sample:NAME:SIZE".
[[nodiscard]] OpenMesh read_mesh_file(const std::string& path);

/// The mesh in the bytes of a file. @param name with the extension of its format
[[nodiscard]] OpenMesh read_mesh_bytes(const std::string& name, std::string bytes);

/// `mesh` with other positions, as a mesh of its own. @param positions 3 × n
[[nodiscard]] OpenMesh mesh_with(const Mesh& mesh, const Positions& positions);

/// `mesh` with its points joined, its panels turned or its triangles joined; what was done is among
/// its warnings. @param asked the options of `planish convert`
[[nodiscard]] OpenMesh make_conversion(const OpenMesh& mesh, const std::string& asked);

/// `design`, holding its base also where that came as arrays.
[[nodiscard]] Design complete(Design design, const OpenMesh& open);

}  // namespace planish::library
