// SPDX-License-Identifier: MIT
/// (8) with the bound that keeps every panel's shape.
#pragma once

#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/projection/projection.hpp"

namespace planish {

/// A mesh whose panels have the shape that they had, flat as far as that allows.
struct SoundProjection {
  Positions positions;           ///< 3 × n, model units
  std::vector<int> failing;      ///< faces above the tolerance, worst first
  double fairness_weight = 0.0;  ///< α_f that gave it
  SolveReport report;

  [[nodiscard]] bool found() const { return positions.cols() > 0; }
  [[nodiscard]] bool is_flat() const { return found() && failing.empty(); }
  [[nodiscard]] bool is_better_than(const SoundProjection& other) const {
    return found() && (!other.found() || failing.size() < other.failing.size());
  }
};

/// Panels that `after` spoilt, ascending: concave, crossing, turned over or collapsed, and not so
/// in `before`. Positions are 3 × n of the whole mesh.
[[nodiscard]] std::vector<int> spoilt_faces(const Mesh& mesh, const Positions& before,
                                            const Positions& after);

/// Tries α_f as asked for (1 where that is 0), then ten and a hundred times as much: a fairer mesh
/// is farther away, but a smooth displacement seldom folds a panel. The first that is flat and
/// sound ends the search; otherwise the sound one with the fewest panels above the tolerance is the
/// result, none of them less flat than it was; without any, `positions` are empty.
/// @param base of the history, or `mesh`: the panels' shape is compared with its, and supports are
///             about it
/// @param free ascending, no pins; the finish may take up to three face rings more where panels
///             cannot become flat otherwise
/// @param pins vertices that stay, bit by bit
[[nodiscard]] SoundProjection project_soundly(const Mesh& mesh, const Mesh& base,
                                              const ProjectionOptions& options,
                                              const std::vector<int>& free,
                                              const std::vector<int>& pins,
                                              const Progress& progress);

}  // namespace planish
