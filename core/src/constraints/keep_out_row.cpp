// SPDX-License-Identifier: MIT
#include "planish/constraints/keep_out_row.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace planish {
namespace {

constexpr double kWidth = 0.5;  ///< sides of a panel from the plane to where s = 1
/// Sides: by which a point that rests may be deeper; what solving and rounding leave.
constexpr double kSlack = 1e-10;

/// At least 1/2 at the base, where the barrier begins [SHP-3]: a point at rest feels no force.
LimitScale barrier_scale(double bound, double range) {
  return {.slope = 1.0 / range, .offset = -bound / range};
}

}  // namespace

double mean_side(const Positions& points, std::span<const int> panel) {
  double sum = 0.0;
  for (std::size_t k = 0; k < panel.size(); ++k) {
    sum += (points.col(panel[(k + 1) % panel.size()]) - points.col(panel[k])).norm();
  }
  return sum > 0.0 ? sum / static_cast<double>(panel.size()) : 1.0;
}

KeptBox in_points(const LimitBase& base, const KeptBox& box) {
  const Eigen::Vector3d way = box.centre - base.mesh.positions.col(0);
  return {base.points.col(0) + way / base.unit, box.halves / base.unit, box.clearance / base.unit};
}

BoxPlane widest_plane(const KeptBox& box, const Positions& panel) {
  constexpr double kParallel = 1e-6;
  BoxPlane widest;
  widest.gap = -std::numeric_limits<double>::infinity();
  const auto take = [&](const Eigen::Vector3d& axis, double scale) {
    const double length = axis.norm();
    if (!(length > kParallel * scale)) return;
    for (const double sign : {1.0, -1.0}) {
      const Eigen::Vector3d normal = sign / length * axis;
      const double bound = normal.dot(box.centre) +
                           (normal.transpose() * box.halves).cwiseAbs().sum() + box.clearance;
      const double gap = (normal.transpose() * panel).minCoeff() - bound;
      if (gap > widest.gap) widest = {normal, bound, gap};
    }
  };
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  const Eigen::Index n = panel.cols();
  for (int c = 0; c < 3; ++c) take(box.halves.col(c), 0.0);
  double sides = 0.0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Vector3d edge = panel.col((k + 1) % n) - panel.col(k);
    area += Eigen::Vector3d(panel.col(k) - panel.col(0)).cross(edge);
    sides += edge.squaredNorm();
    for (int c = 0; c < 3; ++c) {
      take(edge.cross(box.halves.col(c)), edge.norm() * box.halves.col(c).norm());
    }
  }
  take(area, sides);
  return widest;
}

KeepOutRow base_row(const LimitBase& base, int vertex, double side, const Eigen::Vector3d& normal,
                    double room) {
  constexpr double kUlps = 8.0 * std::numeric_limits<double>::epsilon();
  KeepOutRow row;
  row.vertices = {vertex};
  row.normal = normal;
  const double now = normal.dot(base.points.col(vertex));
  row.rests = room <= kRestsWithin * side;
  if (row.rests) {
    const double size = base.mesh.positions.col(vertex).cwiseAbs().maxCoeff();
    row.scale = {1.0 / side, kSlack + kUlps * size / (base.unit * side) - now / side};
  } else {
    row.scale = barrier_scale(now - room, std::min(kWidth * side, 2.0 * room));
  }
  return row;
}

KeepOutRow plane_row(int vertex, const Eigen::Vector3d& place, double side,
                     const Eigen::Vector3d& normal, double bound) {
  KeepOutRow row;
  row.vertices = {vertex};
  row.normal = normal;
  const double room = normal.dot(place) - bound;
  // One that a panel turned to may leave little room at rest: there it acts.
  row.scale = barrier_scale(
      bound, room > kRestsWithin * side ? std::min(kWidth * side, 2.0 * room) : kWidth * side);
  return row;
}

void append_rows(const LimitBase& base, const FreeSpace& free, int face,
                 std::vector<KeepOutRow>& out) {
  const auto panel = base.mesh.face(face);
  const double side = mean_side(base.points, panel);
  for (const int v : panel) {
    if (base.adjacency.faces[v].front() != face) continue;
    for (const HalfSpace& one : free.sides) {
      const Eigen::Vector3d place = base.mesh.positions.col(v);
      const double room = (one.normal.dot(place) - one.bound) / base.unit;
      out.push_back(base_row(base, v, side, one.normal, room));
    }
  }
  if (free.boxes.empty()) return;
  const std::vector<int> corners(panel.begin(), panel.end());
  const Positions points = base.points(Eigen::all, corners);
  for (std::size_t b = 0; b < free.boxes.size(); ++b) {
    const BoxPlane plane = widest_plane(in_points(base, free.boxes[b]), points);
    for (const int v : panel) {
      const double room = plane.normal.dot(base.points.col(v)) - plane.bound;
      out.push_back(base_row(base, v, side, plane.normal, room));
      out.back().panel = face;
      out.back().box = static_cast<int>(b);
    }
  }
}

}  // namespace planish
