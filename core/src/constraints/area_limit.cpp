// SPDX-License-Identifier: MIT
#include "planish/constraints/area_limit.hpp"

#include <Eigen/Geometry>

#include "planish/constraints/vector_pair.hpp"
#include "planish/mesh/area_vector.hpp"

namespace planish {
namespace {

constexpr double kAllowedArea = 1e-3;  ///< of an area beyond the limit: what it may grow by

/// Σ pₖ × pₖ₊₁, relative to the first.
Eigen::Vector3d doubled(const PanelPoints& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = points.col(0);
  for (Eigen::Index k = 1; k + 1 < points.cols(); ++k) {
    sum += (points.col(k) - origin).cross(points.col(k + 1) - origin);
  }
  return sum;
}

/// pₖ₊₁ − pₖ₋₁.
Eigen::Vector3d chord(const PanelPoints& points, Eigen::Index k) {
  const Eigen::Index n = points.cols();
  return points.col((k + 1) % n) - points.col((k + n - 1) % n);
}

}  // namespace

double value(const AreaRow& /*row*/, const PanelPoints& points) {
  return 0.5 * doubled(points).norm();
}

PanelPoints gradient(const AreaRow& /*row*/, const PanelPoints& points) {
  const Eigen::Vector3d normal = doubled(points).normalized();
  PanelPoints result(3, points.cols());
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    result.col(k) = 0.5 * chord(points, k).cross(normal);
  }
  return result;
}

LimitHessian<Eigen::Dynamic> hessian(const AreaRow& /*row*/, const PanelPoints& points) {
  const Eigen::Index n = points.cols();
  const Eigen::Vector3d sum = doubled(points);
  const double size = sum.norm();
  const Eigen::Vector3d normal = sum / size;
  const Eigen::Matrix3d across =
      (Eigen::Matrix3d::Identity() - normal * normal.transpose()) / (2.0 * size);
  Eigen::Matrix3Xd by(3, 3 * n);  // ∂sum/∂p
  for (Eigen::Index k = 0; k < n; ++k) by.middleCols<3>(3 * k) = -cross_matrix(chord(points, k));
  LimitHessian<Eigen::Dynamic> result = by.transpose() * across * by;
  const Eigen::Matrix3d turn = -0.5 * cross_matrix(normal);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index next = (k + 1) % n;
    result.block<3, 3>(3 * k, 3 * next) += turn;
    result.block<3, 3>(3 * next, 3 * k) += turn.transpose();
  }
  return result;
}

void AreaLimit::append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                            std::vector<Row>& out) {
  const auto panel = base.mesh.face(face);
  const double now = 0.5 * area_vector(base.points, panel).norm();
  if (!(now > 0.0)) return;
  const double most = limit.most / (base.unit * base.unit);
  AreaRow row;
  row.vertices.assign(panel.begin(), panel.end());
  row.scale = LimitScale::at_most(most, now, 0.5 * most, kAllowedArea * now);
  out.push_back(std::move(row));
}

}  // namespace planish
