// SPDX-License-Identifier: MIT
/// Where the planes of the panels around a point meet when all of them move outwards alike.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace planish {

struct PlaneMeeting {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  double miss = 0.0;  ///< root mean square distance of the planes from it
  int rank = 0;       ///< directions that the planes decide on; 3: the point is the only one
};

/// The point nearest to all planes n · m = 1, of several the nearest to `guess`. Panels that fold
/// by less than 1e-6 rad count as one plane. [OFF-4]
/// @param normals unit vectors
[[nodiscard]] PlaneMeeting meet_planes(const std::vector<Eigen::Vector3d>& normals,
                                       const Eigen::Vector3d& guess);

}  // namespace planish
