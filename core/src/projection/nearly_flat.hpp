// SPDX-License-Identifier: MIT
/// Meshes between a given one and its flat one: as flat as a largest move lets it, or no flatter
/// than asked for.
#pragma once

#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/projection/projection.hpp"

namespace planish {

struct NearlyFlat {
  Positions positions;  ///< 3 × n, model units; sound
  SolveReport report;   ///< iterations and records; kConverged, or kCancelled
};

/// Walks [PRO-7] until every panel is within the options' tolerance, and stops before a vertex
/// moves farther than `within`, a panel is spoilt, or the worst panel becomes a tenth worse. The
/// result is the first mesh that reaches the tolerance, to a sixth of its μ, or else the one whose
/// worst panel is flattest; the given mesh, if none is flatter.
/// @param free ascending; all other vertices stay
/// @param within model units, > 0; infinite: any
[[nodiscard]] NearlyFlat find_nearly_flat(const Mesh& mesh, const ProjectionOptions& options,
                                          double within, const std::vector<int>& free,
                                          const Progress& progress);

}  // namespace planish
