// SPDX-License-Identifier: MIT
#include "cones.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "planish/adjacency.hpp"

namespace planish::testing {
namespace {

/// The angle between two edges in degrees, from the chord of their unit vectors.
double angle_between(const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  const double half = 0.5 * (first.normalized() - second.normalized()).norm();
  return 2.0 * std::asin(std::min(1.0, half)) * 180.0 / std::numbers::pi;
}

}  // namespace

double worst_cone_defect(const Mesh& mesh, const Positions& positions) {
  const Adjacency adjacency = build_adjacency(mesh);
  double worst = 0.0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto faces = adjacency.faces[v];
    if (adjacency.boundary[static_cast<std::size_t>(v)] != 0 || faces.size() != 4) continue;
    const auto first = mesh.face(faces[0]);
    double sum = 0.0;
    for (const int f : faces) {
      const auto face = mesh.face(f);
      const auto here = std::find(face.begin(), face.end(), v) - face.begin();
      const auto n = static_cast<std::ptrdiff_t>(face.size());
      const int next = face[static_cast<std::size_t>((here + 1) % n)];
      const int last = face[static_cast<std::size_t>((here + n - 1) % n)];
      const Eigen::Vector3d p = positions.col(v);
      const double angle = angle_between(positions.col(next) - p, positions.col(last) - p);
      const auto shared = std::count_if(face.begin(), face.end(), [&](int w) {
        return std::find(first.begin(), first.end(), w) != first.end();
      });
      sum += shared == 2 ? -angle : angle;
    }
    worst = std::max(worst, std::abs(sum));
  }
  return worst;
}

}  // namespace planish::testing
