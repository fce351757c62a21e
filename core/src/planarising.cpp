// SPDX-License-Identifier: MIT
#include "planish/planarising.hpp"

#include "planish/adjacency.hpp"
#include "planish/index.hpp"

namespace planish {

std::vector<int> boundary_vertices(const Mesh& mesh) {
  const Adjacency adjacency = build_adjacency(mesh);
  std::vector<int> vertices;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (adjacency.boundary[at(v)] != 0) vertices.push_back(v);
  }
  return vertices;
}

ProjectionResult planarise(const Mesh& mesh, const Planarising& how, const Progress& progress) {
  ProjectionOptions options;
  options.fairness_weight = how.fairness_weight;
  options.keep_shape = how.keep_shape;
  std::vector<int> pins;
  if (how.keep_boundary) pins = boundary_vertices(mesh);
  return project_to_planar(mesh, options, pins, progress);
}

}  // namespace planish
