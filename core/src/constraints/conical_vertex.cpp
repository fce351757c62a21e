// SPDX-License-Identifier: MIT
#include "planish/constraints/conical_vertex.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/trigonometry.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr std::size_t kStarSize = 5;

/// The angle between two edges, and what its derivatives are made of.
struct EdgeAngle {
  double angle = 0.0;                     ///< radians
  double cosine = 1.0, sine = 0.0;        ///< of the angle
  double first = 1.0, second = 1.0;       ///< lengths of the edges
  Eigen::Vector3d along, along_second;    ///< unit edges
  Eigen::Vector3d toward, toward_second;  ///< unit, across an edge, towards the other one
  Eigen::Vector3d normal;                 ///< unit, of the plane of both
};

EdgeAngle edge_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  EdgeAngle e;
  e.first = a.norm();
  e.second = b.norm();
  e.along = a / e.first;
  e.along_second = b / e.second;
  const Eigen::Vector3d cross = e.along.cross(e.along_second);
  e.sine = cross.norm();
  e.cosine = e.along.dot(e.along_second);
  e.angle = arctangent(e.sine, e.cosine);
  e.normal = cross / e.sine;
  e.toward = e.normal.cross(e.along);
  e.toward_second = e.along_second.cross(e.normal);
  return e;
}

/// ∂²ω by one edge twice: the curvature of a circle about the other edge, on a sphere, and what
/// the length of the edge adds.
Eigen::Matrix3d own_curvature(const EdgeAngle& e, const Eigen::Vector3d& along,
                              const Eigen::Vector3d& toward, double length) {
  const Eigen::Matrix3d turn = toward * along.transpose();
  const Eigen::Matrix3d bend = (e.cosine / e.sine) * e.normal * e.normal.transpose();
  return (bend + turn + turn.transpose()) / (length * length);
}

Eigen::Vector3d arm(const RowPoints<5>& points, int k) {
  return points.col(1 + k % 4) - points.col(0);
}

double defect_of(const RowPoints<5>& points) {
  double sum = 0.0;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d a = arm(points, k);
    const Eigen::Vector3d b = arm(points, k + 1);
    const double angle = arctangent(a.cross(b).norm(), a.dot(b));
    sum += k % 2 == 0 ? angle : -angle;
  }
  return sum;
}

RowPoints<5> star_points(const Positions& positions, std::span<const int> star) {
  RowPoints<5> points;
  for (std::size_t k = 0; k < kStarSize; ++k) {
    points.col(static_cast<Eigen::Index>(k)) = positions.col(star[k]);
  }
  return points;
}

}  // namespace

double residual(const ConeEquation& equation, const RowPoints<5>& points) {
  return equation.scale * defect_of(points);
}

RowPoints<5> gradient(const ConeEquation& equation, const RowPoints<5>& points) {
  RowPoints<5> result = RowPoints<5>::Zero();
  for (int k = 0; k < 4; ++k) {
    const EdgeAngle e = edge_angle(arm(points, k), arm(points, k + 1));
    const double sign = k % 2 == 0 ? equation.scale : -equation.scale;
    result.col(1 + k) -= (sign / e.first) * e.toward;
    result.col(1 + (k + 1) % 4) -= (sign / e.second) * e.toward_second;
  }
  result.col(0) = -result.rightCols<4>().rowwise().sum();
  return result;
}

CurvatureBlocks<5, true> hessian(const ConeEquation& equation, const RowPoints<5>& points) {
  std::array<std::array<Eigen::Matrix3d, 5>, 5> h;  // blocks of all five vertices
  for (auto& row : h) row.fill(Eigen::Matrix3d::Zero());
  for (int k = 0; k < 4; ++k) {
    const EdgeAngle e = edge_angle(arm(points, k), arm(points, k + 1));
    const double sign = k % 2 == 0 ? equation.scale : -equation.scale;
    const std::size_t a = at(1 + k);
    const std::size_t b = at(1 + (k + 1) % 4);
    h[a][a] += sign * own_curvature(e, e.along, e.toward, e.first);
    h[b][b] += sign * own_curvature(e, e.along_second, e.toward_second, e.second);
    const double both = -sign / (e.first * e.second * e.sine);
    const Eigen::Matrix3d mixed = both * e.normal * e.normal.transpose();
    h[a][b] += mixed;
    h[b][a] += mixed;
  }
  // The blocks of the vertex follow because moving all five points together changes nothing.
  for (std::size_t k = 1; k < kStarSize; ++k) {
    for (std::size_t l = 1; l < kStarSize; ++l) h[k][0] -= h[k][l];
    h[0][0] -= h[k][0];
  }
  CurvatureBlocks<5, true> blocks;
  std::size_t next = 0;
  for (std::size_t k = 0; k < kStarSize; ++k) {
    for (std::size_t l = 0; l <= k; ++l) blocks[next++] = h[k][l];
  }
  return blocks;
}

double cone_defect(const Positions& positions, std::span<const int> star) {
  constexpr double kDegrees = 180.0 / kPi;
  if (star.size() != kStarSize) return 0.0;
  return kDegrees * std::abs(defect_of(star_points(positions, star)));
}

void ConicalVertex::append_rows(const Positions& positions, std::span<const int> star,
                                std::vector<Row>& out) {
  if (star.size() != kStarSize) return;
  const RowPoints<5> points = star_points(positions, star);
  double mean = 0.0;
  for (int k = 0; k < 4; ++k) mean += 0.25 * arm(points, k).norm();
  Row row{{}, mean};
  std::copy(star.begin(), star.end(), row.vertices.begin());
  out.push_back(row);
}

double ConicalVertex::excess(const Positions& positions, std::span<const int> star) {
  constexpr double kUnits = 16.0;  // four angles of two edges, each off by up to √3/2 ε |p| twice
  constexpr double kDegrees = 180.0 / kPi;
  constexpr double kCoarsest = 1e-3;
  double largest = 0.0;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < star.size(); ++k) {
    largest = std::max(largest, positions.col(star[k]).cwiseAbs().maxCoeff());
    if (k == 0) continue;
    shortest = std::min(shortest, (positions.col(star[k]) - positions.col(star[0])).norm());
  }
  const double step = std::numeric_limits<double>::epsilon() * largest;
  const double defect = measure(positions, star);
  const bool is_rounding = defect <= std::min(kCoarsest, kDegrees * kUnits * step / shortest);
  return is_rounding ? 0.0 : defect;
}

}  // namespace planish
