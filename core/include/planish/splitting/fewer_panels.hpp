// SPDX-License-Identifier: MIT
/// Two panels become one, or a strip of quads goes: what is around is solved again, nothing else.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/problem/solve_report.hpp"

namespace planish {

/// How much may move for it.
struct NearbyOptions {
  int reach = 2;            ///< ≥ 0: rings of panels around what is joined whose corners may move
  double tolerance = 1e-6;  ///< mm/m, of every panel in that reach
};

/// The mesh with fewer panels: flat, and each panel as sound as it was. Points keep their numbers;
/// those that belong to no panel any more stay. Numbers of panels close up.
struct FewerPanels {
  Mesh mesh;
  std::vector<int> parents;  ///< one a panel: which of the mesh that was given, the first of two
  std::vector<int> moved;    ///< points whose bits changed, ascending
  double max_move = 0.0;     ///< model units
};

/// Panels `panel` and `other` as one, which keeps the number of the first; or one sentence that
/// says why not. Points beyond the reach keep their bits. [SPL-3]
/// @param mesh must have passed check_mesh() and be flat to the tolerance around the panels
[[nodiscard]] std::variant<FewerPanels, std::string> merge_panels(const Mesh& mesh, int panel,
                                                                  int other,
                                                                  const NearbyOptions& options,
                                                                  const Progress& progress = {});

/// The strip of quads across the edge from `from` to `to` goes, both ways until the boundary or a
/// panel that is no quad: sides that it crosses become one point, the one on `from`'s side, in
/// their middle, or on the boundary where one end of the side alone is there.
[[nodiscard]] std::variant<FewerPanels, std::string> collapse_strip(const Mesh& mesh, int from,
                                                                    int to,
                                                                    const NearbyOptions& options,
                                                                    const Progress& progress = {});

}  // namespace planish
