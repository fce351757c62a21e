// SPDX-License-Identifier: MIT
#include "planish/constraints/slide_limit.hpp"

#include <algorithm>

#include "planish/mesh/mean_normal.hpp"

namespace planish {

double value(const SlideRow& row, const RowPoints<1>& points) {
  return across(points - row.place, row.normal).squaredNorm();
}

RowPoints<1> gradient(const SlideRow& row, const RowPoints<1>& points) {
  return 2.0 * across(points - row.place, row.normal);
}

LimitHessian<1> hessian(const SlideRow& row, const RowPoints<1>& /*points*/) {
  return 2.0 * (Eigen::Matrix3d::Identity() - row.normal * row.normal.transpose());
}

void SlideLimit::append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                             std::vector<Row>& out) {
  const double most = limit.most / base.unit;
  for (const int vertex : base.mesh.face(face)) {
    const auto around = base.adjacency.faces[vertex];
    if (*std::min_element(around.begin(), around.end()) != face) continue;
    SlideRow row;
    row.vertices = {vertex};
    row.place = base.points.col(vertex);
    row.normal = mean_normal(base.mesh, base.points, around);
    // Nothing slides in the base.
    row.scale = LimitScale::at_most(most * most, 0.0, most * most, most * most);
    out.push_back(row);
  }
}

}  // namespace planish
