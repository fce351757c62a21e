// SPDX-License-Identifier: MIT
#include "planish/constraints/fold_limit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "constraints/face_across.hpp"
#include "numeric/trigonometry.hpp"
#include "planish/constraints/vector_pair.hpp"
#include "planish/mesh/area_vector.hpp"

namespace planish {
namespace {

constexpr double kAllowedFold = 0.1 * kPi / 180.0;  ///< by which a fold beyond the limit may grow

/// The largest fold that is allowed, radians. @param now cosine of the fold in the base
double bound_of(const StatedLimit& limit, double now) {
  const double fold = arctangent(std::sqrt(std::max(0.0, 1.0 - now * now)), now);
  const double asked = limit.most * kPi / 180.0 + (limit.relative ? fold : 0.0);
  return std::max(asked, fold + kAllowedFold);
}

struct Wings {
  Eigen::Vector3d edge, here, there;  ///< from the first end of the edge
  Eigen::Vector3d normal, other;      ///< not of length 1
};

Wings wings_of(const RowPoints<4>& points) {
  Wings wings;
  wings.edge = points.col(1) - points.col(0);
  wings.here = points.col(2) - points.col(0);
  wings.there = points.col(3) - points.col(0);
  wings.normal = wings.edge.cross(wings.here);
  wings.other = wings.there.cross(wings.edge);
  return wings;
}

/// ∂normal/∂(edge, here) and ∂other/∂(edge, there) as derivatives by the four points.
struct Normals {
  Eigen::Matrix<double, 3, 12> normal = Eigen::Matrix<double, 3, 12>::Zero();
  Eigen::Matrix<double, 3, 12> other = Eigen::Matrix<double, 3, 12>::Zero();
};

Normals derivatives_of(const Wings& wings) {
  const Eigen::Matrix3d edge = cross_matrix(wings.edge);
  const Eigen::Matrix3d here = cross_matrix(wings.here), there = cross_matrix(wings.there);
  Normals by;
  by.normal.middleCols<3>(3) = -here;
  by.normal.middleCols<3>(6) = edge;
  by.normal.leftCols<3>() = here - edge;
  by.other.middleCols<3>(3) = there;
  by.other.middleCols<3>(9) = -edge;
  by.other.leftCols<3>() = edge - there;
  return by;
}

/// Adds d²(m · (a × b)) for a = p_i − p_0 and b = p_j − p_0.
void add_bilinear(const Eigen::Vector3d& m, int i, int j, LimitHessian<4>& sum) {
  const Eigen::Matrix3d block = -cross_matrix(m);  // ∂²/∂a∂b
  const auto add = [&](int k, int l, const Eigen::Matrix3d& part) {
    sum.block<3, 3>(3 * k, 3 * l) += part;
    sum.block<3, 3>(3 * l, 3 * k) += part.transpose();
  };
  add(i, j, block);
  add(i, 0, -block);
  add(0, j, -block);
  // (0, 0): block + blockᵀ = 0.
}

/// The point of `face` that makes the largest triangle with an edge.
int widest(const Positions& points, std::span<const int> face, int a, int b) {
  const Eigen::Vector3d origin = points.col(a);
  const Eigen::Vector3d edge = points.col(b) - origin;
  int best = -1;
  double largest = 0.0;
  for (const int v : face) {
    const double area = edge.cross(points.col(v) - origin).squaredNorm();
    if (area > largest) {
      largest = area;
      best = v;
    }
  }
  return best;
}

/// +1 where the triangle (a, b, v) runs round like its face, −1 where against it.
double sense(const Positions& points, std::span<const int> face, int a, int b, int v) {
  const Eigen::Vector3d origin = points.col(a);
  const Eigen::Vector3d normal = (points.col(b) - origin).cross(points.col(v) - origin);
  return normal.dot(area_vector(points, face)) < 0.0 ? -1.0 : 1.0;
}

}  // namespace

double value(const FoldRow& row, const RowPoints<4>& points) {
  const Wings wings = wings_of(points);
  return row.side * wings.normal.normalized().dot(wings.other.normalized());
}

RowPoints<4> gradient(const FoldRow& row, const RowPoints<4>& points) {
  const Wings wings = wings_of(points);
  const VectorPair pair = cosine_of(wings.normal, wings.other);
  const Normals by = derivatives_of(wings);
  const Eigen::Matrix<double, 12, 1> all =
      row.side * (by.normal.transpose() * pair.by_u + by.other.transpose() * pair.by_v);
  return Eigen::Map<const RowPoints<4>>(all.data());
}

LimitHessian<4> hessian(const FoldRow& row, const RowPoints<4>& points) {
  const Wings wings = wings_of(points);
  const VectorPair pair = cosine_of(wings.normal, wings.other);
  const Normals by = derivatives_of(wings);
  LimitHessian<4> mixed = by.normal.transpose() * pair.uv * by.other;
  LimitHessian<4> sum =
      by.normal.transpose() * pair.uu * by.normal + by.other.transpose() * pair.vv * by.other;
  sum += mixed + mixed.transpose();
  add_bilinear(pair.by_u, 1, 2, sum);
  add_bilinear(pair.by_v, 3, 1, sum);
  return row.side * sum;
}

void FoldLimit::append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                            std::vector<Row>& out) {
  const auto panel = base.mesh.face(face);
  for (std::size_t k = 0; k < panel.size(); ++k) {
    const int a = panel[k], b = panel[(k + 1) % panel.size()];
    const FaceAcross other = face_across(base, face, a, b);
    if (other.face <= face) continue;
    const auto there = base.mesh.face(other.face);
    FoldRow row;
    row.vertices = {a, b, widest(base.points, panel, a, b), widest(base.points, there, a, b)};
    row.panels = {face, other.face};
    if (row.vertices[2] < 0 || row.vertices[3] < 0 || row.vertices[2] == row.vertices[3]) continue;
    // A neighbour that is oriented alike runs through the edge from b to a.
    row.side = sense(base.points, panel, a, b, row.vertices[2]) *
               sense(base.points, there, b, a, row.vertices[3]) * (other.forward ? -1.0 : 1.0);
    RowPoints<4> points;
    for (int c = 0; c < 4; ++c)
      points.col(c) = base.points.col(row.vertices[static_cast<std::size_t>(c)]);
    const double most = bound_of(limit, value(row, points));
    if (most >= kPi) continue;
    const double bound = cosine(most);
    row.scale = LimitScale::at_least(bound, value(row, points), 0.5 * (1.0 - bound), 0.0);
    row.scale.exceeded = !limit.relative && most > limit.most * kPi / 180.0;
    out.push_back(row);
  }
}

}  // namespace planish
