// SPDX-License-Identifier: MIT
/// A mesh as Python holds it: checked, with what a design must know of its origin.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "planish/design.hpp"
#include "planish/mesh.hpp"

namespace planish::python {

using Points = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;
using Indices = pybind11::array_t<long long, pybind11::array::c_style | pybind11::array::forcecast>;

/// Never changes once it is made.
struct OpenMesh {
  Mesh mesh;
  DesignSource source;
  std::vector<std::string> warnings;
  std::string name;  ///< for messages
};

/// Throws CommandError, as all of these do, naming what is wrong.
/// @param points (n, 3)  @param offsets f + 1  @param corners offsets[f] vertex indices
[[nodiscard]] OpenMesh mesh_of_arrays(const Points& points, const Indices& offsets,
                                      const Indices& corners);

/// The mesh at `path` (.obj .off .ply .glb), or "sample:NAME:SIZE".
[[nodiscard]] OpenMesh read_mesh_file(const std::string& path);

/// `mesh` with other positions, as a mesh of its own. @param positions 3 × n
[[nodiscard]] OpenMesh mesh_with(const Mesh& mesh, const Positions& positions);

/// (n, 3), a copy.
[[nodiscard]] Points points_array(const Positions& positions);

/// What does not lie in `after` (3 × n) where it does in `before`, ascending.
[[nodiscard]] Indices moved_array(const Positions& before, const Positions& after);

/// The source of `open` with the bytes that make a design complete.
[[nodiscard]] DesignSource complete_source(const OpenMesh& open);

}  // namespace planish::python
