// SPDX-License-Identifier: MIT
#include "support/slides.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace planish::testing {

std::vector<double> slides(const Mesh& mesh, const Positions& after) {
  const Positions& p = mesh.positions;
  Positions normals = Positions::Zero(3, mesh.vertex_count());
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t k = 2; k < face.size(); ++k) {
      area += (p.col(face[k - 1]) - p.col(face[0])).cross(p.col(face[k]) - p.col(face[0]));
    }
    for (const int v : face) normals.col(v) += area;
  }
  std::vector<double> found;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Eigen::Vector3d move = after.col(v) - p.col(v), normal = normals.col(v);
    found.push_back(move.cross(normal).norm() / normal.norm());
  }
  return found;
}

double largest_slide(const Mesh& mesh, const Positions& after) {
  const std::vector<double> all = slides(mesh, after);
  return *std::max_element(all.begin(), all.end());
}

}  // namespace planish::testing
