// SPDX-License-Identifier: MIT
#include "offset/edge_directions.hpp"

#include <cstddef>

#include "mesh/edge_table.hpp"

namespace planish {

std::vector<DirectedEdge> directed_edges(const Mesh& mesh) {
  constexpr double kPoint = 1e-9;
  const double shortest = kPoint * mean_edge_length(mesh);
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  std::vector<DirectedEdge> edges;
  for (const auto side : by_edge(uses)) {
    DirectedEdge edge{side[0].low, side[0].high};
    const Eigen::Vector3d along = mesh.positions.col(edge.to) - mesh.positions.col(edge.from);
    if (along.stableNorm() > shortest) edge.direction = along.stableNormalized();
    edges.push_back(edge);
  }
  return edges;
}

}  // namespace planish
