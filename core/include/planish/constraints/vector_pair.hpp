// SPDX-License-Identifier: MIT
/// Functions of two vectors that are sums of points, with their derivatives.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace planish {

/// A value of two vectors u and v, its gradient and its second derivatives.
struct VectorPair {
  double value = 0.0;
  Eigen::Vector3d by_u = Eigen::Vector3d::Zero();
  Eigen::Vector3d by_v = Eigen::Vector3d::Zero();
  Eigen::Matrix3d uu = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d uv = Eigen::Matrix3d::Zero();  ///< rows by u
  Eigen::Matrix3d vv = Eigen::Matrix3d::Zero();
};

/// cos ∠(u, v). Neither may be zero.
[[nodiscard]] VectorPair cosine_of(const Eigen::Vector3d& u, const Eigen::Vector3d& v);

/// The squared length of u along v. v may not be zero.
[[nodiscard]] VectorPair squared_along(const Eigen::Vector3d& u, const Eigen::Vector3d& v);

/// The squared length of u across v. v may not be zero.
[[nodiscard]] VectorPair squared_across(const Eigen::Vector3d& u, const Eigen::Vector3d& v);

/// [m]×: the matrix of m × ·
[[nodiscard]] inline Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& m) {
  Eigen::Matrix3d result;
  result << 0.0, -m.z(), m.y(), m.z(), 0.0, -m.x(), -m.y(), m.x(), 0.0;
  return result;
}

}  // namespace planish
