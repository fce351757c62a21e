// SPDX-License-Identifier: MIT
#include "planish/constraints/angle_limit.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/trigonometry.hpp"
#include "planish/constraints/vector_pair.hpp"
#include "planish/mesh/area_vector.hpp"

namespace planish {
namespace {

constexpr double kAllowed = 0.1 * kPi / 180.0;  ///< by which an angle beyond the limit may go on

VectorPair pair_of(const RowPoints<3>& points) {
  return cosine_of(points.col(0) - points.col(1), points.col(2) - points.col(1));
}

bool is_reflex(const Positions& points, std::span<const int> face, const RowPoints<3>& corner) {
  const Eigen::Vector3d in = corner.col(1) - corner.col(0);
  const Eigen::Vector3d out = corner.col(2) - corner.col(1);
  return area_vector(points, face).dot(in.cross(out)) < 0.0;
}

}  // namespace

double value(const AngleRow& /*row*/, const RowPoints<3>& points) { return pair_of(points).value; }

RowPoints<3> gradient(const AngleRow& /*row*/, const RowPoints<3>& points) {
  const VectorPair pair = pair_of(points);
  RowPoints<3> result;
  result << pair.by_u, -pair.by_u - pair.by_v, pair.by_v;
  return result;
}

LimitHessian<3> hessian(const AngleRow& /*row*/, const RowPoints<3>& points) {
  const VectorPair pair = pair_of(points);
  const Eigen::Matrix3d vu = pair.uv.transpose();
  LimitHessian<3> result;
  result << pair.uu, -pair.uu - pair.uv, pair.uv,                           //
      -pair.uu - vu, pair.uu + pair.uv + vu + pair.vv, -pair.uv - pair.vv,  //
      vu, -vu - pair.vv, pair.vv;
  return result;
}

void AngleLimit::append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                             std::vector<Row>& out) {
  const auto panel = base.mesh.face(face);
  const std::size_t n = panel.size();
  const double least = limit.least * kPi / 180.0, most = limit.most * kPi / 180.0;
  const double width = 0.25 * (cosine(least) - cosine(most));
  for (std::size_t k = 0; k < n; ++k) {
    AngleRow row;
    row.vertices = {panel[(k + n - 1) % n], panel[k], panel[(k + 1) % n]};
    RowPoints<3> corner;
    for (int c = 0; c < 3; ++c) {
      corner.col(c) = base.points.col(row.vertices[static_cast<std::size_t>(c)]);
    }
    if (corner.col(0) == corner.col(1) || corner.col(1) == corner.col(2)) continue;
    if (is_reflex(base.points, panel, corner)) continue;
    const double now = value(row, corner);
    const double angle = arctangent(std::sqrt(std::max(0.0, 1.0 - now * now)), now);
    const double low = std::min(least, angle - kAllowed), high = std::max(most, angle + kAllowed);
    if (low > 0.0) {
      row.scale = LimitScale::at_most(cosine(low), now, width, 0.0);
      row.scale.exceeded = angle < least;
      out.push_back(row);
    }
    if (high < kPi) {
      row.scale = LimitScale::at_least(cosine(high), now, width, 0.0);
      row.scale.exceeded = angle > most;
      out.push_back(row);
    }
  }
}

}  // namespace planish
