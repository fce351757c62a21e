// SPDX-License-Identifier: MIT
#include "planish/constraints/circular_polygon.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/constraints/vector_pair.hpp"

namespace planish {
namespace {

constexpr double kRadian = 57.29577951308232;  ///< degrees
constexpr double kAreaShare = 1e-6;            ///< of the squared perimeter: less is no area

/// Unit area vector, or zero for a face without area.
Eigen::Vector3d face_normal(const Positions& positions, std::span<const int> face) {
  const std::size_t n = face.size();
  const auto arm = [&](std::size_t k) -> Eigen::Vector3d {
    return positions.col(face[k % n]) - positions.col(face[0]);
  };
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  double perimeter = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    area += arm(k).cross(arm(k + 1));
    perimeter += (arm(k + 1) - arm(k)).norm();
  }
  const double size = area.norm();
  if (!(size > kAreaShare * perimeter * perimeter)) return Eigen::Vector3d::Zero();
  return area / size;
}

/// ∂²c/∂x² and ∂²c/∂x∂y of [CIR-1] for edges x → y → z in cyclic order.
struct EdgeCurvature {
  Eigen::Matrix3d own, next;
};
EdgeCurvature edge_curvature(const Eigen::Vector3d& n, const Eigen::Vector3d& x,
                             const Eigen::Vector3d& y, const Eigen::Vector3d& z) {
  return {2.0 * n.dot(y.cross(z)) * Eigen::Matrix3d::Identity(),
          2.0 * x * z.cross(n).transpose() + 2.0 * n.cross(z) * y.transpose() -
              z.squaredNorm() * cross_matrix(n)};
}

/// The angle between two edges, in degrees; accurate near 0 and 180 too.
double angle(const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  return kRadian * std::atan2(first.cross(second).norm(), first.dot(second));
}

double quad_defect(const std::array<Eigen::Vector3d, 4>& p) {
  std::array<double, 4> angles{};
  for (std::size_t k = 0; k < 4; ++k) {
    angles[k] = angle(p[(k + 1) % 4] - p[k], p[(k + 3) % 4] - p[k]);
  }
  return std::max(std::abs(angles[0] + angles[2] - 180.0), std::abs(angles[1] + angles[3] - 180.0));
}

}  // namespace

double residual(const CircleEquation& equation, const RowPoints<4>& points) {
  const Eigen::Vector3d u = points.col(1) - points.col(0);
  const Eigen::Vector3d v = points.col(2) - points.col(0);
  const Eigen::Vector3d w = points.col(3) - points.col(0);
  return equation.normal.dot(u.squaredNorm() * v.cross(w) + v.squaredNorm() * w.cross(u) +
                             w.squaredNorm() * u.cross(v));
}

RowPoints<4> gradient(const CircleEquation& equation, const RowPoints<4>& points) {
  const Eigen::Vector3d& n = equation.normal;
  const Eigen::Vector3d u = points.col(1) - points.col(0);
  const Eigen::Vector3d v = points.col(2) - points.col(0);
  const Eigen::Vector3d w = points.col(3) - points.col(0);
  const Eigen::Vector3d nu = u.squaredNorm() * n;
  const Eigen::Vector3d nv = v.squaredNorm() * n;
  const Eigen::Vector3d nw = w.squaredNorm() * n;
  RowPoints<4> result;
  result.col(1) = 2.0 * n.dot(v.cross(w)) * u + nv.cross(w) + v.cross(nw);
  result.col(2) = 2.0 * n.dot(w.cross(u)) * v + nw.cross(u) + w.cross(nu);
  result.col(3) = 2.0 * n.dot(u.cross(v)) * w + nu.cross(v) + u.cross(nv);
  result.col(0) = -(result.col(1) + result.col(2) + result.col(3));
  return result;
}

CurvatureBlocks<4, true> hessian(const CircleEquation& equation, const RowPoints<4>& points) {
  const Eigen::Vector3d& n = equation.normal;
  const Eigen::Vector3d u = points.col(1) - points.col(0);
  const Eigen::Vector3d v = points.col(2) - points.col(0);
  const Eigen::Vector3d w = points.col(3) - points.col(0);
  const auto [h11, h12] = edge_curvature(n, u, v, w);
  const auto [h22, h23] = edge_curvature(n, v, w, u);
  const auto [h33, h31] = edge_curvature(n, w, u, v);
  const Eigen::Matrix3d h21 = h12.transpose();
  const Eigen::Matrix3d h32 = h23.transpose();
  // The blocks of vertex 0 follow because moving all four points together changes nothing.
  const Eigen::Matrix3d h10 = -(h11 + h12 + h31.transpose());
  const Eigen::Matrix3d h20 = -(h21 + h22 + h23);
  const Eigen::Matrix3d h30 = -(h31 + h32 + h33);
  const Eigen::Matrix3d h00 = -(h10 + h20 + h30);
  return {h00, h10, h11, h20, h21, h22, h30, h31, h32, h33};
}

void append_circle_equations(const Positions& positions, std::span<const int> face,
                             std::vector<CircleEquation>& out) {
  if (face.size() < 4) return;
  const Eigen::Vector3d normal = face_normal(positions, face);
  if (normal.isZero(0.0)) return;
  const std::array<std::size_t, 3> carriers = spread_corners(positions, face);
  std::array<int, 4> corners{};
  for (std::size_t k = 0; k < 3; ++k) corners[k] = face[carriers[k]];
  const auto length = [&](std::size_t k, std::size_t l) {
    return (positions.col(corners[k]) - positions.col(corners[l])).norm();
  };
  // The product of a triangle's sides is four times its area times the radius of its circle.
  const double sides = length(0, 1) * length(1, 2) * length(2, 0);
  if (!(sides > 0.0)) return;
  for (std::size_t k = 0; k < face.size(); ++k) {
    if (std::find(carriers.begin(), carriers.end(), k) != carriers.end()) continue;
    corners[3] = face[k];
    out.push_back({corners, normal / sides});
  }
}

double circle_defect(const Positions& positions, std::span<const int> face) {
  const std::size_t n = face.size();
  if (n < 4) return 0.0;
  double worst = 0.0;
  for (std::size_t first = 0; first < (n == 4 ? 1 : n); ++first) {
    std::array<Eigen::Vector3d, 4> quad;
    for (std::size_t k = 0; k < 4; ++k) quad[k] = positions.col(face[(first + k) % n]);
    const double defect = quad_defect(quad);
    if (!(defect <= worst)) worst = defect;  // negated, so that a NaN is the worst of all
  }
  return worst;
}

double CircularPolygon::excess(const Positions& positions, std::span<const int> face) {
  constexpr double kUnits = 16.0;  // four angles of two edges, each off by up to √3/2 ε |p| twice
  constexpr double kCoarsest = 1e-3;
  double largest = 0.0;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < face.size(); ++k) {
    largest = std::max(largest, positions.col(face[k]).cwiseAbs().maxCoeff());
    const int next = face[(k + 1) % face.size()];
    shortest = std::min(shortest, (positions.col(next) - positions.col(face[k])).norm());
  }
  const double step = std::numeric_limits<double>::epsilon() * largest;
  const double defect = measure(positions, face);
  const bool is_rounding = defect <= std::min(kCoarsest, kRadian * kUnits * step / shortest);
  return is_rounding ? 0.0 : defect;
}

}  // namespace planish
