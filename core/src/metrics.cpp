// SPDX-License-Identifier: MIT
#include "planish/metrics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <limits>

#include "planish/constraints/planar_polygon.hpp"

namespace planish {
namespace {

/// mm/m that rounding leaves of a flat panel: half a unit in the last place per coordinate moves a
/// corner by up to √3/2 ε |p|, two corners apart, and as much again for the plane through them.
double rounding_mm_per_m(double largest_coordinate, double longest_edge) {
  constexpr double kUnits = 4.0;
  constexpr double kCoarsest = 1e-3;  // a panel that holds less is not called flat
  const double step = std::numeric_limits<double>::epsilon() * largest_coordinate;
  return std::min(kCoarsest, 1000.0 * kUnits * step / longest_edge);
}

}  // namespace

FacePlanarity face_planarity(const Positions& positions, std::span<const int> face) {
  if (face.size() < 4) return {};
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  // Relative to the first vertex: far from the origin the mean itself would round too coarsely.
  const Eigen::Vector3d origin = positions.col(face[0]);
  for (const int v : face) mean += positions.col(v) - origin;
  mean /= static_cast<double>(face.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double longest = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    largest = std::max(largest, positions.col(face[k]).cwiseAbs().maxCoeff());
    const Eigen::Vector3d here = positions.col(face[k]) - origin;
    const Eigen::Vector3d next = positions.col(face[(k + 1) % face.size()]) - origin;
    longest = std::max(longest, (next - here).norm());
    covariance.noalias() += (here - mean) * (here - mean).transpose();
  }
  if (!(longest > 0.0)) return {};
  covariance /= longest * longest;  // the decomposition must not underflow on tiny models
  const Eigen::Vector3d first = positions.col(face[2]) - origin;
  const Eigen::Vector3d second = positions.col(face[3]) - positions.col(face[1]);
  const Eigen::Vector3d guess = first.cross(second).stableNormalized();
  const Eigen::Vector3d normal = smallest_direction(covariance, guess);
  double low = 0.0;
  double high = 0.0;
  for (const int v : face) {
    const Eigen::Vector3d here = positions.col(v) - origin;
    const double distance = normal.dot(here - mean);
    low = std::min(low, distance);
    high = std::max(high, distance);
  }
  const double mm_per_m = 1000.0 * (high - low) / longest;
  const bool is_rounding = mm_per_m <= rounding_mm_per_m(largest, longest);  // false for NaN
  return {high - low, mm_per_m, is_rounding ? 0.0 : mm_per_m};
}

PlanaritySummary planarity_summary(const Mesh& mesh) {
  return planarity_summary(mesh, mesh.positions);
}

PlanaritySummary planarity_summary(const Mesh& mesh, const Positions& positions) {
  PlanaritySummary summary;
  int counted = 0;
  double sum = 0.0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() < 4) continue;
    const FacePlanarity here = face_planarity(positions, mesh.face(f));
    ++counted;
    sum += here.mm_per_m;
    if (!(here.mm_per_m <= summary.max) || summary.worst_face < 0) {
      summary.max = here.mm_per_m;
      summary.worst_face = f;
      summary.worst_gap = here.gap;
    }
    summary.max_gap = std::max(summary.max_gap, here.gap);
    if (!(here.excess <= summary.max_excess)) summary.max_excess = here.excess;
  }
  if (counted > 0) summary.mean = sum / counted;
  return summary;
}

int degrees_of_freedom(const Mesh& mesh) {
  std::vector<char> used(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (const int v : mesh.face_vertices) used[static_cast<std::size_t>(v)] = 1;
  int freedom = 3 * static_cast<int>(std::count(used.begin(), used.end(), 1));
  for (int f = 0; f < mesh.face_count(); ++f) {
    freedom -= static_cast<int>(mesh.face(f).size()) - 3;
  }
  return freedom;
}

int moved_vertex_count(const Positions& before, const Positions& after) {
  int moved = 0;
  for (Eigen::Index v = 0; v < before.cols(); ++v) {
    if (std::memcmp(before.col(v).data(), after.col(v).data(), 3 * sizeof(double)) != 0) ++moved;
  }
  return moved;
}

}  // namespace planish
