// SPDX-License-Identifier: MIT
#include "planish/constraints/vector_pair.hpp"

namespace planish {

VectorPair cosine_of(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  const double length_u = u.norm(), length_v = v.norm();
  const Eigen::Vector3d a = u / length_u, b = v / length_v;
  const double c = a.dot(b);
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d ab = a * b.transpose(), aa = a * a.transpose(), bb = b * b.transpose();
  VectorPair pair;
  pair.value = c;
  pair.by_u = (b - c * a) / length_u;
  pair.by_v = (a - c * b) / length_v;
  pair.uu = (3.0 * c * aa - c * unit - ab - ab.transpose()) / (length_u * length_u);
  pair.vv = (3.0 * c * bb - c * unit - ab - ab.transpose()) / (length_v * length_v);
  pair.uv = (unit - aa - bb + c * ab) / (length_u * length_v);
  return pair;
}

VectorPair squared_along(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  const double length = v.norm();
  const Eigen::Vector3d b = v / length;
  const double t = u.dot(b);
  const Eigen::Vector3d across = (u - t * b) / length;  // ∂t/∂v
  const Eigen::Matrix3d turn = (Eigen::Matrix3d::Identity() - b * b.transpose()) / length;  // ∂b/∂v
  VectorPair pair;
  pair.value = t * t;
  pair.by_u = 2.0 * t * b;
  pair.by_v = 2.0 * t * across;
  pair.uu = 2.0 * b * b.transpose();
  pair.uv = 2.0 * (b * across.transpose() + t * turn);
  const Eigen::Matrix3d bends =
      -(b * across.transpose() + across * b.transpose() + t * turn) / length;  // ∂²t/∂v²
  pair.vv = 2.0 * (across * across.transpose() + t * bends);
  return pair;
}

VectorPair squared_across(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  const VectorPair along = squared_along(u, v);
  VectorPair pair;
  pair.value = u.squaredNorm() - along.value;
  pair.by_u = 2.0 * u - along.by_u;
  pair.by_v = -along.by_v;
  pair.uu = 2.0 * Eigen::Matrix3d::Identity() - along.uu;
  pair.uv = -along.uv;
  pair.vv = -along.vv;
  return pair;
}

}  // namespace planish
