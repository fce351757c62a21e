// SPDX-License-Identifier: MIT
#include "boundary_outline.hpp"

#include <Eigen/Geometry>

#include "planish/index.hpp"

namespace planish {

BoundaryOutline::BoundaryOutline(const Mesh& mesh)
    : mesh_(mesh), before_(at(mesh.vertex_count()), -1), after_(at(mesh.vertex_count()), -1) {
  const Adjacency adjacency = build_adjacency(mesh);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto around = adjacency.neighbours[v];
    const bool simple = adjacency.boundary[at(v)] && adjacency.regular[at(v)];
    if (!simple || around.size() < 2) continue;
    before_[at(v)] = around.front();
    after_[at(v)] = around.back();
  }
}

int BoundaryOutline::beside(int vertex, int side) const {
  return side == 0 ? before_[at(vertex)] : after_[at(vertex)];
}

bool BoundaryOutline::is_corner(int vertex) const {
  constexpr double kLeastCosine = 0.866025403784438647;  // of kSharpTurn
  const int before = beside(vertex, 0), after = beside(vertex, 1);
  if (before < 0 || after < 0) return true;
  const Eigen::Vector3d in = mesh_.positions.col(vertex) - mesh_.positions.col(before);
  const Eigen::Vector3d out = mesh_.positions.col(after) - mesh_.positions.col(vertex);
  return !(in.dot(out) > kLeastCosine * in.norm() * out.norm());
}

}  // namespace planish
