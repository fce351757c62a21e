// SPDX-License-Identifier: MIT
#include "fabrication/node_axis.hpp"

#include <vector>

#include "numeric/plane_meeting.hpp"
#include "planish/mesh/area_vector.hpp"

namespace planish {

Eigen::Vector3d node_axis(const Mesh& mesh, const Positions& positions, const Adjacency& adjacency,
                          int vertex) {
  constexpr double kMeets = 1e-9;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> normals;
  for (const int f : adjacency.faces[vertex]) {
    const Eigen::Vector3d area = area_vector(positions, mesh.face(f));
    axis += area;
    if (!area.isZero(0.0)) normals.emplace_back(area.stableNormalized());
  }
  axis.stableNormalize();
  if (axis.isZero(0.0)) axis = Eigen::Vector3d::UnitZ();
  if (normals.size() < 3) return axis;
  const PlaneMeeting meeting = meet_planes(normals, axis);
  return meeting.rank == 3 && meeting.miss <= kMeets ? meeting.point.normalized() : axis;
}

}  // namespace planish
