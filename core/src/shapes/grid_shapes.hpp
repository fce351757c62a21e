// SPDX-License-Identifier: MIT
/// Samples with flat quads on a grid of points. `size` is points along one side, ≥ 3.
#pragma once

#include "planish/mesh/mesh.hpp"

namespace planish {

/// A translational vault over a square: every quad is a parallelogram.
[[nodiscard]] Mesh make_vault(int size);

/// A piece of a surface of revolution: every quad is a trapezium.
[[nodiscard]] Mesh make_dome(int size);

/// An asymmetric roof: a translational surface with bent profiles, seen through a projective map,
/// which keeps planes planes. About size² points.
[[nodiscard]] Mesh make_freeform(int size);

/// A canopy curved both ways like a shell, a piece of a torus: every quad is a trapezium. About
/// size² points, in the proportion of 3 to 2.
[[nodiscard]] Mesh make_roof(int size);

}  // namespace planish
