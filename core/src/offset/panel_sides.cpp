// SPDX-License-Identifier: MIT
#include "offset/panel_sides.hpp"

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "mesh/edge_table.hpp"
#include "planish/mesh/area_vector.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

struct Neighbour {
  int face = 0;
  bool clashes = false;  ///< is oriented the other way
};

std::vector<std::vector<Neighbour>> neighbours_by_edge(const Mesh& mesh) {
  std::vector<std::vector<Neighbour>> neighbours(at(mesh.face_count()));
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for (const auto edge : by_edge(uses)) {
    if (edge.size() != 2) continue;
    const bool clashes = edge[0].forward == edge[1].forward;
    neighbours[at(edge[0].face)].push_back({edge[1].face, clashes});
    neighbours[at(edge[1].face)].push_back({edge[0].face, clashes});
  }
  return neighbours;
}

/// 1 or −1 for each face, so that neighbours show the same side; nullopt if that cannot be.
std::optional<std::vector<int>> face_signs(const Mesh& mesh) {
  const auto neighbours = neighbours_by_edge(mesh);
  std::vector<int> signs(at(mesh.face_count()), 0);
  std::vector<int> piece;
  for (int start = 0; start < mesh.face_count(); ++start) {
    if (signs[at(start)] != 0) continue;
    signs[at(start)] = 1;
    piece.assign(1, start);
    int sum = 0;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const int here = signs[at(piece[k])];
      sum += here;
      for (const Neighbour& next : neighbours[at(piece[k])]) {
        const int wanted = next.clashes ? -here : here;
        int& sign = signs[at(next.face)];
        if (sign == -wanted) return std::nullopt;
        if (sign == 0) piece.push_back(next.face);
        sign = wanted;
      }
    }
    for (const int f : piece) signs[at(f)] *= sum < 0 ? -1 : 1;
  }
  return signs;
}

}  // namespace

std::optional<OutsideNormals> outside_normals(const Mesh& mesh) {
  const auto signs = face_signs(mesh);
  if (!signs) return std::nullopt;
  OutsideNormals normals;
  normals.faces.resize(3, mesh.face_count());
  normals.vertices.setZero(3, mesh.vertex_count());
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Eigen::Vector3d area = (*signs)[at(f)] * area_vector(mesh.positions, face);
    normals.faces.col(f) = area.stableNormalized();
    for (const int v : face) normals.vertices.col(v) += area;
  }
  for (auto normal : normals.vertices.colwise()) normal.stableNormalize();
  return normals;
}

}  // namespace planish
