// SPDX-License-Identifier: MIT
/// Meshes and points as numpy has them.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "open_mesh.hpp"

namespace planish::python {

using Points = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;
using Indices = pybind11::array_t<long long, pybind11::array::c_style | pybind11::array::forcecast>;

/// Throws MeshError, naming what is wrong.
/// @param points (n, 3)  @param offsets f + 1  @param corners offsets[f] vertex indices
[[nodiscard]] library::OpenMesh mesh_of_arrays(const Points& points, const Indices& offsets,
                                               const Indices& corners);

/// (n, 3), a copy.
[[nodiscard]] Points points_array(const Positions& positions);

/// What does not lie in `after` (3 × n) where it does in `before`, ascending.
[[nodiscard]] Indices moved_array(const Positions& before, const Positions& after);

}  // namespace planish::python
