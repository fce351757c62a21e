// SPDX-License-Identifier: MIT
/// glTF's frame: y up, float32, near the origin.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// z up → y up: a permutation, so no bit is lost.
[[nodiscard]] inline Eigen::Vector3d to_y_up(const Eigen::Vector3d& p) {
  return {p.x(), p.z(), -p.y()};
}
[[nodiscard]] inline Eigen::Vector3d to_z_up(const Eigen::Vector3d& p) {
  return {p.x(), -p.z(), p.y()};
}

/// The nearest float that is finite: a viewer can do nothing with infinity.
[[nodiscard]] inline float to_float(double value) {
  constexpr auto kLargest = static_cast<double>(std::numeric_limits<float>::max());
  return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

/// A place near a mesh that lies far away (a site in national coordinates), where float32 would
/// lose its shape; zero for any other mesh. Model frame.
[[nodiscard]] inline Eigen::Vector3d display_origin(const Positions& positions) {
  constexpr double kFar = 100.0;
  const Eigen::Vector3d low = positions.rowwise().minCoeff();
  const Eigen::Vector3d high = positions.rowwise().maxCoeff();
  const double extent = (high - low).maxCoeff();
  const Eigen::Vector3d centre = 0.5 * low + 0.5 * high;
  if (centre.cwiseAbs().maxCoeff() <= kFar * extent) return Eigen::Vector3d::Zero();
  return centre;
}

}  // namespace planish
