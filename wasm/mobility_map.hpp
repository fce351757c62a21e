// SPDX-License-Identifier: MIT
/// Where the mesh that the page shows can move, vertex by vertex. A module of its own in the
/// browser, in a worker of its own: nothing else waits for it.
#pragma once

#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/mobility/mobility_meter.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

/// The edits of the page as mobility makes them: within the reach that keeps a vertex cheap, and
/// with the limit on folds that a drag has, unless one is stated.
[[nodiscard]] MobilityOptions map_options(HandleEditOptions edit);

/// Why `mesh` has no map; nullopt if it has one.
[[nodiscard]] Refusal find_map_problem(const Mesh& mesh, const MobilityOptions& options);

/// One base mesh and what has been measured of it.
class MobilityMap {
 public:
  /// find_map_problem() must find none.
  MobilityMap(Mesh mesh, const MobilityOptions& options);
  MobilityMap(const MobilityMap&) = delete;
  MobilityMap& operator=(const MobilityMap&) = delete;

  /// Four rows for a vertex of the mesh, which best() knows from then on.
  std::vector<MobilityRow> measure(int vertex);
  /// The best of what has been measured, see best_places().
  [[nodiscard]] std::vector<MobilityRow> best(int count) const;

 private:
  Mesh mesh_;
  Adjacency adjacency_;
  MobilityMeter meter_;  ///< looks at mesh_
  std::vector<MobilityRow> rows_;
};

}  // namespace planish
