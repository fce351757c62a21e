// SPDX-License-Identifier: MIT
#include "support/circles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace planish::testing {
namespace {

/// The angle at `apex` over a chord, in degrees: by law of cosines in extended precision, where the
/// product has an arc tangent.
long double angle_over(const Eigen::Vector3d& apex, const Eigen::Vector3d& from,
                       const Eigen::Vector3d& to) {
  using Exact = Eigen::Matrix<long double, 3, 1>;
  const Exact a = (from - apex).cast<long double>();
  const Exact b = (to - apex).cast<long double>();
  const Exact c = b / b.norm() - a / a.norm();  // chord of the unit circle
  return 2.0L * std::asin(std::min(1.0L, c.norm() / 2.0L)) * 180.0L /
         std::numbers::pi_v<long double>;
}

Eigen::Vector3d onto_sphere(double x, double y, double radius) {
  const double square = (x * x + y * y) / (4.0 * radius * radius);
  return Eigen::Vector3d(x, y, 2.0 * radius * square) / (1.0 + square);
}

}  // namespace

Mesh honeycomb_on_sphere(int side) {
  const double wide = std::sqrt(3.0);
  std::map<std::pair<long, long>, int> numbers;
  std::vector<Eigen::Vector3d> points;
  Mesh mesh;
  mesh.face_offsets.assign(1, 0);
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const double x = wide * (i + 0.5 * (j % 2) - 0.5 * side);
      const double y = 1.5 * (j - 0.5 * side);
      for (int k = 0; k < 6; ++k) {
        const double t = std::numbers::pi * (2 * k + 1) / 6.0;
        const double px = x + std::cos(t);
        const double py = y + std::sin(t);
        const auto key = std::pair(std::lround(1e4 * px), std::lround(1e4 * py));
        const auto [place, added] = numbers.try_emplace(key, static_cast<int>(points.size()));
        if (added) points.push_back(onto_sphere(px, py, 2.0 * side));
        mesh.face_vertices.push_back(place->second);
      }
      mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
    }
  }
  mesh.positions.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    mesh.positions.col(static_cast<Eigen::Index>(k)) = points[k];
  }
  return mesh;
}

double inscribed_defect(const Positions& positions, std::span<const int> face) {
  if (face.size() < 4) return 0.0;
  const Eigen::Vector3d from = positions.col(face[0]);
  const Eigen::Vector3d to = positions.col(face[2]);
  const long double here = angle_over(positions.col(face[1]), from, to);
  long double worst = 0.0L;
  for (std::size_t k = 3; k < face.size(); ++k) {
    const long double across = angle_over(positions.col(face[k]), from, to);
    worst = std::max(worst, std::abs(here + across - 180.0L));
  }
  return static_cast<double>(worst);
}

double inscribed_defect(const Mesh& mesh, const Positions& positions) {
  double worst = 0.0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    worst = std::max(worst, inscribed_defect(positions, mesh.face(f)));
  }
  return worst;
}

}  // namespace planish::testing
