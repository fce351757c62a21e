// SPDX-License-Identifier: MIT
/// A flat mesh changed a little so that more of its panels are alike: fewer types, still flat.
#pragma once

#include <vector>

#include "planish/constraints/stated_limit.hpp"
#include "planish/families/families.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/supports/point_support.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

struct FewerTypesOptions {
  double within = 0.0;    ///< > 0, model units: how far a corner may be from its template's
  int most_types = 0;     ///< ≥ 1 in place of `within`: the smallest distance with so many types
  double move = 0.0;      ///< > 0, model units: no point moves farther
  bool mirrored = false;  ///< a panel may be its template turned over
  double tolerance = 1e-6;  ///< mm/m, > 0, of every panel
  /// Relative to the mesh as given, as those of edits.
  std::vector<StatedLimit> bounds = {};
  /// What points stand on, about the mesh as given; no springs. They must pass find_problem() on
  /// it.
  std::vector<PointSupport> supports = {};
};

/// `stated`, and 5 degrees for how much folds may grow where it has no limit on them: without one
/// panels may turn until nobody would build it.
[[nodiscard]] std::vector<StatedLimit> bounds_of_fewer_types(std::vector<StatedLimit> stated);

[[nodiscard]] Refusal find_problem(const FewerTypesOptions& options);

/// The first rule that `options` break on `mesh`, which must be flat and have no more kinds of
/// polygons than types are asked for.
[[nodiscard]] Refusal find_problem(const FewerTypesOptions& options, const Mesh& mesh);

/// A mesh with as few types as were found: flat, no panel spoilt that was not, within the limits,
/// no point farther.
struct FewerTypes {
  Positions positions;  ///< 3 × n, model units; what did not move has its bits
  double within = 0.0;  ///< of the types, model units: asked for, or the smallest found
  bool mirrored = false;
  int before = 0;         ///< types of the given mesh within that
  Families types;         ///< of the result, within that; outlines as flatten_panel() has them
  double max_move = 0.0;  ///< model units
  double rms_move = 0.0;  ///< over all vertices, model units
  bool reached = true;    ///< no more types than were asked for
  int descents = 0;       ///< how often it was tried
  bool merging = false;   ///< the last tries still found fewer
  bool cancelled = false;
  double seconds = 0.0;
  SolveCost cost;
};

/// Sorts panels into families wider than `within`, pulls each towards its template, and sorts
/// again, wide and then narrower, until nothing merges any more. Deterministic. [FEW-2]
/// @param mesh flat, with no problem
/// @param pins vertices that must not move
/// @param progress after every sorting; kStop ends with the best so far
[[nodiscard]] FewerTypes find_fewer_types(const Mesh& mesh, const FewerTypesOptions& options,
                                          const std::vector<int>& pins,
                                          const Progress& progress = {});

}  // namespace planish
