// SPDX-License-Identifier: MIT
/// What offsets promise, measured without the product's code.
#pragma once

#include <optional>

#include "planish/mesh/mesh.hpp"
#include "planish/offset/mesh_offset.hpp"

namespace planish::testing {

/// The offset; fails the test with the sentence where there is none.
[[nodiscard]] MeshOffset offset_of(const Mesh& mesh, double distance,
                                   std::optional<OffsetKind> kind = std::nullopt);

/// Why there is none; "" where there is one.
[[nodiscard]] std::string refusal(const Mesh& mesh, std::optional<OffsetKind> kind = std::nullopt);

/// Largest sine of the angle between an edge and the one that belongs to it in `after`.
[[nodiscard]] double worst_angle(const Mesh& mesh, const Positions& after);

/// How far the planes of the panels in `after` are from `distance` beside their own, the worst.
[[nodiscard]] double worst_plane(const Mesh& mesh, const Positions& after, double distance);

/// How far the points are from |distance| apart, the worst.
[[nodiscard]] double worst_point(const Mesh& mesh, const Positions& after, double distance);

/// m × n quads around a ring: conical and circular.
[[nodiscard]] Mesh torus(int around, int across);

/// A surface of revolution that is open at both ends, `around` quads a ring.
[[nodiscard]] Mesh vase(int around, int rings);

/// The cube with corners at ±1, seen anticlockwise from outside.
[[nodiscard]] Mesh cube();

}  // namespace planish::testing
