// SPDX-License-Identifier: MIT
/// (8) with the bound that keeps every panel's shape.
#pragma once

#include <span>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/projection/projection.hpp"

namespace planish {

/// A mesh whose panels have the shape that they had, flat as far as that allows.
struct SoundProjection {
  Positions positions;           ///< 3 × n, model units
  std::vector<int> failing;      ///< faces above the tolerance, worst first
  double squared_move = 0.0;     ///< Σ ‖move‖², model units
  double fairness_weight = 0.0;  ///< α_f that gave it
  SolveReport report;

  [[nodiscard]] bool found() const { return positions.cols() > 0; }
  [[nodiscard]] bool is_flat() const { return found() && failing.empty(); }
  /// Whether nothing further need be tried: flat, sound and certified.
  [[nodiscard]] bool is_final() const {
    return is_flat() && report.status == SolveStatus::kConverged;
  }
  /// Whether nothing better need be looked for. What has more points than are factored is never
  /// looked at twice once it is flat.
  [[nodiscard]] bool ends_search(int vertex_count) const;
  /// Whether fewer panels are not flat; of flat ones the certified one, then the nearer one is
  /// better.
  [[nodiscard]] bool is_better_than(const SoundProjection& other) const;
};

/// Panels that `after` spoilt, ascending: concave, crossing, turned over or collapsed, and not so
/// in `before`. Positions are 3 × n of the whole mesh.
[[nodiscard]] std::vector<int> spoilt_faces(const Mesh& mesh, const Positions& before,
                                            const Positions& after);

/// Panels that `after` tips over, ascending: turned by more than 60° and seen, from where they
/// faced, at less than a quarter of their area. What a strong α_f may make of a panel that another
/// displacement leaves where it is. Positions are 3 × n of the whole mesh.
[[nodiscard]] std::vector<int> tipped_faces(const Mesh& mesh, const Positions& before,
                                            const Positions& after);

/// How one solve goes: with which share of the α_f asked for (1 where that is 0), and whether the
/// panels become flat gradually, so that corners that come to their bound give way to others.
struct Rung {
  double share;
  bool gradual;
};

/// Climbs `ladder` up to the first rung that is flat, sound and certified. Otherwise the result is
/// the best of the sound ones, none of its panels less flat than it was; without any, `positions`
/// are empty.
/// @param base of the history, or `mesh`: the panels' shape is compared with its, and supports are
///             about it
/// @param free ascending, no pins; the finish may take up to three face rings more where panels
///             cannot become flat otherwise
/// @param pins vertices that stay, bit by bit
/// @param ladder tried in this order
[[nodiscard]] SoundProjection project_soundly(const Mesh& mesh, const Mesh& base,
                                              const ProjectionOptions& options,
                                              const std::vector<int>& free,
                                              const std::vector<int>& pins,
                                              std::span<const Rung> ladder,
                                              const Progress& progress);

}  // namespace planish
