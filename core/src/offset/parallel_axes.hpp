// SPDX-License-Identifier: MIT
/// Offset vectors that keep every edge parallel, as near to the normals as they can be.
#pragma once

#include <functional>
#include <vector>

#include "offset/edge_directions.hpp"
#include "offset/panel_sides.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

struct FittedAxes {
  Positions axes;     ///< 3 × n
  double miss = 0.0;  ///< largest residual of a row; where no axes keep all rows, not small
};

/// min ½ Σ ‖m_i − n_i‖²  s.t.  (I − d dᵀ)(m_i − m_j) = 0 for every edge, d its direction, [OFF-1]
/// and with `equal_planes` n_f · m_i = 1 for every corner i of every panel f: all planes at the
/// distance 1. By multipliers y on the rows A m = b, r = A m − b:
///   (I + ρ AᵀA) δ = n − m − Aᵀy − ρ Aᵀr,  m ← m + δ,  y ← y + ρ r [OFF-2]
/// The rows are far from independent; this form needs no rank. On closed meshes some combinations
/// of them hold almost, and forbidding those too can cost all of the height: where the steps come
/// to rest at `good_enough`, they are let be, else ρ rises.
[[nodiscard]] FittedAxes fit_axes(const Mesh& mesh, const std::vector<DirectedEdge>& edges,
                                  const OutsideNormals& normals, bool equal_planes,
                                  const std::function<bool(const FittedAxes&)>& good_enough);

}  // namespace planish
