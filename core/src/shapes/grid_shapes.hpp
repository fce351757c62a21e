// SPDX-License-Identifier: MIT
/// Samples with flat quads on a grid of points. `size` is points along one side, ≥ 3.
#pragma once

#include "planish/mesh.hpp"

namespace planish {

/// A translational vault over a square: every quad is a parallelogram.
[[nodiscard]] Mesh make_vault(int size);

/// A piece of a surface of revolution: every quad is a trapezium.
[[nodiscard]] Mesh make_dome(int size);

/// An asymmetric roof: a translational surface with bent profiles, seen through a projective map,
/// which keeps planes planes. About size² points.
[[nodiscard]] Mesh make_freeform(int size);

}  // namespace planish
