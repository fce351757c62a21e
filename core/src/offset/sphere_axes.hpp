// SPDX-License-Identifier: MIT
/// Offset vectors of one length that keep every edge parallel.
#pragma once

#include <vector>

#include "offset/edge_directions.hpp"
#include "offset/parallel_axes.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Unit vectors m with m_j = m_i − 2 (d · m_i) d along every edge: the other end of the chord of
/// the unit sphere along d. So one vector s a piece gives all the others, m_i = Q_i s, and the
/// edges that close a loop are linear in it. Of all s that close them, the one whose vectors are
/// nearest to the normals, s ∝ Σ Q_iᵀ n_i. [OFF-3]
[[nodiscard]] FittedAxes reflect_axes(const std::vector<DirectedEdge>& edges,
                                      const Positions& normals);

}  // namespace planish
