// SPDX-License-Identifier: MIT
#include "planish/mesh.hpp"

#include <algorithm>
#include <utility>

namespace planish {

double mean_edge_length(const Mesh& mesh) {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(mesh.face_vertices.size());
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      edges.push_back(std::minmax(face[k], face[(k + 1) % face.size()]));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  if (edges.empty()) return 0.0;
  double sum = 0.0;
  for (const auto& [a, b] : edges) sum += (mesh.positions.col(a) - mesh.positions.col(b)).norm();
  return sum / static_cast<double>(edges.size());
}

}  // namespace planish
