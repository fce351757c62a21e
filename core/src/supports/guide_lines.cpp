// SPDX-License-Identifier: MIT
#include "supports/guide_lines.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"

namespace planish {

GuideLines::GuideLines(const Mesh& mesh, const std::vector<PointSupport>& supports)
    : mesh_(mesh), before_(at(mesh.vertex_count()), -1), after_(at(mesh.vertex_count()), -1) {
  const auto is_outline = [](const PointSupport& support) {
    return support.kind == PointSupport::Kind::kOutline;
  };
  if (std::any_of(supports.begin(), supports.end(), is_outline)) add_boundary();
  for (const auto add : {&GuideLines::add_polyline, &GuideLines::end_polyline}) {
    for (const PointSupport& support : supports) {
      if (support.kind == PointSupport::Kind::kPolyline) (this->*add)(support.vertices);
    }
  }
}

void GuideLines::add_boundary() {
  const Adjacency adjacency = build_adjacency(mesh_);
  for (int v = 0; v < mesh_.vertex_count(); ++v) {
    const auto around = adjacency.neighbours[v];
    const bool simple = adjacency.boundary[at(v)] && adjacency.regular[at(v)];
    if (!simple || around.size() < 2) continue;
    before_[at(v)] = around.front();
    after_[at(v)] = around.back();
  }
}

void GuideLines::add_polyline(const std::vector<int>& vertices) {
  for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
    before_[at(vertices[k])] = vertices[k - 1];
    after_[at(vertices[k])] = vertices[k + 1];
  }
  if (vertices.front() != vertices.back()) return;
  before_[at(vertices.front())] = vertices[vertices.size() - 2];
  after_[at(vertices.front())] = vertices[1];
}

void GuideLines::end_polyline(const std::vector<int>& vertices) {
  if (vertices.front() == vertices.back()) return;
  for (const int v : {vertices.front(), vertices.back()}) before_[at(v)] = after_[at(v)] = -1;
}

int GuideLines::beside(int vertex, int side) const {
  return side == 0 ? before_[at(vertex)] : after_[at(vertex)];
}

bool GuideLines::is_corner(int vertex) const {
  constexpr double kLeastCosine = 0.866025403784438647;  // of 30°
  const int before = beside(vertex, 0), after = beside(vertex, 1);
  if (before < 0 || after < 0) return true;
  const Eigen::Vector3d in = mesh_.positions.col(vertex) - mesh_.positions.col(before);
  const Eigen::Vector3d out = mesh_.positions.col(after) - mesh_.positions.col(vertex);
  return !(in.dot(out) > kLeastCosine * in.norm() * out.norm());
}

}  // namespace planish
