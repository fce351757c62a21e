// SPDX-License-Identifier: MIT
#include "planish/mesh/area_vector.hpp"

#include <Eigen/Geometry>

namespace planish {

Eigen::Vector3d area_vector(const Positions& positions, std::span<const int> face) {
  const Eigen::Vector3d origin = positions.col(face[0]);
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Eigen::Vector3d a = positions.col(face[k]) - origin;
    const Eigen::Vector3d b = positions.col(face[(k + 1) % face.size()]) - origin;
    area += a.cross(b);
  }
  return area;
}

}  // namespace planish
