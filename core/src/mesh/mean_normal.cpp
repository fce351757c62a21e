// SPDX-License-Identifier: MIT
#include "planish/mesh/mean_normal.hpp"

#include "planish/mesh/area_vector.hpp"

namespace planish {

Eigen::Vector3d mean_normal(const Mesh& mesh, const Positions& positions,
                            std::span<const int> faces) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int f : faces) sum += area_vector(positions, mesh.face(f));
  const double length = sum.norm();
  return length > 0.0 ? Eigen::Vector3d(sum / length) : Eigen::Vector3d::Zero();
}

}  // namespace planish
