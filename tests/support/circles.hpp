// SPDX-License-Identifier: MIT
/// Circular meshes, and what makes them so, measured without the product's code.
#pragma once

#include <Eigen/Core>
#include <span>

#include "planish/mesh/mesh.hpp"

namespace planish::testing {

/// Regular hexagons of side 1, projected from the pole onto a sphere: circles stay circles, so that
/// all panels are flat and circular. @param side hexagons along each way
[[nodiscard]] Mesh honeycomb_on_sphere(int side);

/// Degrees by which the vertices of a face miss a circle, by inscribed angles: those that the other
/// vertices span over the chord from the first vertex to the third. On a circle they are equal on
/// one side, and add up to 180° across it.
[[nodiscard]] double inscribed_defect(const Positions& positions, std::span<const int> face);

/// The worst over a mesh.
[[nodiscard]] double inscribed_defect(const Mesh& mesh, const Positions& positions);

}  // namespace planish::testing
