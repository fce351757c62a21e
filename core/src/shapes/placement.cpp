// SPDX-License-Identifier: MIT
#include "shapes/placement.hpp"

namespace planish {

void place_with_unit_edges(Mesh& mesh) {
  const Eigen::Vector3d low = mesh.positions.rowwise().minCoeff();
  const Eigen::Vector3d high = mesh.positions.rowwise().maxCoeff();
  const Eigen::Vector3d foot(0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), low.z());
  mesh.positions.colwise() -= foot;
  mesh.positions /= mean_edge_length(mesh);
}

}  // namespace planish
