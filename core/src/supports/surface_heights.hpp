// SPDX-License-Identifier: MIT
/// Distances of points from the surface of a support. [SUP-4]
#pragma once

#include <optional>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/supports/point_support.hpp"

namespace planish {

/// How much each of `points` is farther above a side of the surface in `shape` than in
/// the base, at most; model units.
/// @param support of kind kSurface @param shape 3 × n
[[nodiscard]] std::vector<double> ways_off_surface(const PointSupport& support, const Mesh& base,
                                                   const std::vector<int>& points,
                                                   const Positions& shape);

/// A point and how far it is from something, model units.
struct FarPoint {
  int vertex = 0;
  double distance = 0.0;
};

/// The first point of `support` that is farther than `most` from its surface; none is from a
/// surface that is the mesh itself.
[[nodiscard]] std::optional<FarPoint> far_from_surface(const PointSupport& support,
                                                       const Mesh& mesh, double most);

}  // namespace planish
