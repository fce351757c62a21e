// SPDX-License-Identifier: MIT
#include "splitting/line_moment.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace planish {
namespace {

/// The corners of a panel between two of them, the way round.
std::vector<int> corners_between(std::span<const int> corners, int from, int to) {
  const auto start = std::find(corners.begin(), corners.end(), from);
  std::vector<int> between;
  for (std::size_t c = 1; c < corners.size(); ++c) {
    const std::size_t place = static_cast<std::size_t>(start - corners.begin()) + c;
    const int v = corners[place % corners.size()];
    if (v == to) break;
    between.push_back(v);
  }
  return between;
}

}  // namespace

double moment_across(const Mesh& mesh, const Positions& shape, std::span<const CornerForce> forces,
                     const SplitCut& cut) {
  const int from = cut.start.vertex, to = cut.end.vertex;
  const std::vector<int> side = corners_between(mesh.face(cut.panel), from, to);
  const Eigen::Vector3d start = shape.col(from);
  const Eigen::Vector3d along = (shape.col(to) - start).normalized();
  double moment = 0.0;
  for (const CornerForce& one : forces) {
    if (one.panel != cut.panel) continue;
    if (std::find(side.begin(), side.end(), one.vertex) == side.end()) continue;
    const Eigen::Vector3d arm = shape.col(one.vertex) - start;
    moment += along.dot(arm.cross(one.force));
  }
  return std::abs(moment);
}

}  // namespace planish
