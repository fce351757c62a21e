// SPDX-License-Identifier: MIT
#include "planish/fabrication/panel_frame.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// The way from one end of `side` to the other.
Eigen::Vector3d along(const Positions& positions, std::span<const int> face, int side) {
  const std::size_t next = (at(side) + 1) % face.size();
  return positions.col(face[next]) - positions.col(face[at(side)]);
}

// Sums are written out here: Eigen adds the three products of a row in an order that depends on
// where they lie in memory, and the page's tables would differ from the command line's in their
// last digit.
double product(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// `symmetric` times `b`.
Eigen::Vector3d product(const Eigen::Matrix3d& symmetric, const Eigen::Vector3d& b) {
  return {product(Eigen::Vector3d(symmetric.col(0)), b),
          product(Eigen::Vector3d(symmetric.col(1)), b),
          product(Eigen::Vector3d(symmetric.col(2)), b)};
}

/// `v` at length 1, however large; zero stays zero.
Eigen::Vector3d unit(const Eigen::Vector3d& v) {
  const double size = v.cwiseAbs().maxCoeff();
  if (!(size > 0.0)) return v;
  const Eigen::Vector3d scaled = v / size;
  return scaled / std::sqrt(product(scaled, scaled));
}

/// Normal of the best-fit plane, as smallest_direction() finds it: Rayleigh quotients from `guess`.
Eigen::Vector3d best_normal(const Eigen::Matrix3Xd& corners, const Eigen::Vector3d& guess) {
  constexpr int kSteps = 3;
  constexpr double kAccuracy = 1e-13;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto corner : corners.colwise()) mean += corner;
  mean /= static_cast<double>(corners.cols());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto corner : corners.colwise()) {
    const Eigen::Vector3d p = corner - mean;
    for (Eigen::Index k = 0; k < 3; ++k) covariance.col(k) += p(k) * p;
  }
  const double size = covariance(0, 0) + covariance(1, 1) + covariance(2, 2);
  Eigen::Vector3d n = guess;
  for (int step = 0; step < kSteps && size > 0.0 && !n.isZero(); ++step) {
    const Eigen::Vector3d image = product(covariance, n);
    const double theta = product(n, image);
    Eigen::Matrix3d a = covariance;
    for (Eigen::Index k = 0; k < 3; ++k) a(k, k) -= theta;
    Eigen::Matrix3d adjugate;
    for (Eigen::Index k = 0; k < 3; ++k) {
      adjugate.col(k) =
          Eigen::Vector3d(a.col((k + 1) % 3)).cross(Eigen::Vector3d(a.col((k + 2) % 3)));
    }
    const Eigen::Vector3d rest = image - theta * n;
    if (std::sqrt(product(rest, rest)) <= kAccuracy * size) {
      const double second = adjugate(0, 0) + adjugate(1, 1) + adjugate(2, 2);
      if (a(0, 0) + a(1, 1) + a(2, 2) > 0.0 && second > kAccuracy * size * size) return n;
      break;
    }
    const Eigen::Vector3d next = product(adjugate, n);
    const double length = std::sqrt(product(next, next));
    if (!(length > 0.0) || !std::isfinite(length)) break;
    n = next / length;
  }
  return smallest_direction(covariance, Eigen::Vector3d::Zero());
}

}  // namespace

Eigen::Vector3d panel_normal(const Positions& positions, std::span<const int> face) {
  const Eigen::Vector3d area = unit(area_vector(positions, face));
  if (face.size() == 3 && !area.isZero(0.0)) return area;
  Eigen::Matrix3Xd corners(3, static_cast<Eigen::Index>(face.size()));
  for (std::size_t k = 0; k < face.size(); ++k) {
    corners.col(static_cast<Eigen::Index>(k)) = positions.col(face[k]) - positions.col(face[0]);
  }
  const double size = corners.cwiseAbs().maxCoeff();  // huge coordinates must not overflow
  if (size > 0.0) corners /= size;
  const Eigen::Vector3d normal = best_normal(corners, area);
  if (!normal.allFinite() || normal.isZero(0.0)) return Eigen::Vector3d::UnitZ();
  return normal.dot(area) < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

int longest_side(const Positions& positions, std::span<const int> face) {
  constexpr double kEqual = 1.0 + 1e-9;
  int longest = 0;
  for (int side = 1; side < static_cast<int>(face.size()); ++side) {
    const double length = along(positions, face, side).stableNorm();
    if (length > kEqual * along(positions, face, longest).stableNorm()) longest = side;
  }
  return longest;
}

PanelFrame panel_frame(const Positions& positions, std::span<const int> face, int side) {
  PanelFrame frame;
  frame.origin = positions.col(face[0]);
  frame.normal = panel_normal(positions, face);
  const Eigen::Vector3d edge = unit(along(positions, face, side));
  const Eigen::Vector3d across = frame.normal.cross(edge);
  const bool usable = across.norm() > 0.5;  // a panel without length or plane has no direction
  frame.y = usable ? unit(across) : frame.normal.unitOrthogonal();
  frame.x = unit(frame.y.cross(frame.normal));
  return frame;
}

}  // namespace planish
