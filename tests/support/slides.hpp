// SPDX-License-Identifier: MIT
/// How far points slide along the surface of a mesh, measured without the code under test. [MET-5]
#pragma once

#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish::testing {

/// Of every point, from `mesh` to `after`: across the mean normal of the panels around it in
/// `mesh`.
[[nodiscard]] std::vector<double> slides(const Mesh& mesh, const Positions& after);

/// The largest of them.
[[nodiscard]] double largest_slide(const Mesh& mesh, const Positions& after);

}  // namespace planish::testing
