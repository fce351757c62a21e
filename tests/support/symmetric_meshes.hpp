// SPDX-License-Identifier: MIT
/// Meshes with a symmetry that is known, and what is measured of it without the code under test.
#pragma once

#include <Eigen/Core>
#include <string>

#include "planish/mesh/mesh.hpp"
#include "planish/symmetry/symmetry.hpp"

namespace planish::testing {

/// A surface of revolution about a vertical axis: flat quads between rings of `sides` points, its
/// first point at `angle` (radians) from x. Vertex ring · sides + k.
[[nodiscard]] Mesh turned_surface(int sides, int rings, const Eigen::Vector3d& centre = {0, 0, 0},
                                  double angle = 0.0);

/// The symmetry that a text asks for; fails the test where the mesh does not have it.
[[nodiscard]] MeshSymmetry symmetry_of(const Mesh& mesh, const std::string& text);

/// Largest distance of a point mirrored in the plane `axis` = `at` from the nearest point, model
/// units; O(n²).
[[nodiscard]] double mirror_error(const Positions& positions, int axis, double at);

/// The same of the points turned by 2π/order about a vertical axis.
[[nodiscard]] double turn_error(const Positions& positions, int order,
                                const Eigen::Vector3d& centre);

/// Whether every point has one with exactly the coordinate 2 · at − x and the same other bits.
[[nodiscard]] bool is_mirrored_to_the_bit(const Positions& positions, int axis, double at);

}  // namespace planish::testing
