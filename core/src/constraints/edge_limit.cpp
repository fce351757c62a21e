// SPDX-License-Identifier: MIT
#include "planish/constraints/edge_limit.hpp"

#include "constraints/face_across.hpp"

namespace planish {
namespace {

constexpr double kAllowedSquare =
    2e-3;  ///< of a squared length beyond the limit: what it may go on by

}  // namespace

double value(const EdgeRow& /*row*/, const RowPoints<2>& points) {
  return (points.col(1) - points.col(0)).squaredNorm();
}

RowPoints<2> gradient(const EdgeRow& /*row*/, const RowPoints<2>& points) {
  const Eigen::Vector3d edge = 2.0 * (points.col(1) - points.col(0));
  RowPoints<2> result;
  result << -edge, edge;
  return result;
}

LimitHessian<2> hessian(const EdgeRow& /*row*/, const RowPoints<2>& /*points*/) {
  const Eigen::Matrix3d twice = 2.0 * Eigen::Matrix3d::Identity();
  LimitHessian<2> result;
  result << twice, -twice, -twice, twice;
  return result;
}

void EdgeLimit::append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                            std::vector<Row>& out) {
  const auto panel = base.mesh.face(face);
  const double least = limit.least / base.unit, most = limit.most / base.unit;
  const double width = 0.25 * (most * most - least * least);
  for (std::size_t k = 0; k < panel.size(); ++k) {
    EdgeRow row;
    row.vertices = {panel[k], panel[(k + 1) % panel.size()]};
    row.panels = {face, face_across(base, face, row.vertices[0], row.vertices[1]).face};
    if (row.panels[1] >= 0 && row.panels[1] < face) continue;
    const double now =
        (base.points.col(row.vertices[1]) - base.points.col(row.vertices[0])).squaredNorm();
    const double allowed = kAllowedSquare * (now > 0.0 ? now : most * most);
    if (least > 0.0) {
      row.scale = LimitScale::at_least(least * least, now, width, allowed);
      out.push_back(row);
    }
    row.scale = LimitScale::at_most(most * most, now, width, allowed);
    out.push_back(row);
  }
}

}  // namespace planish
