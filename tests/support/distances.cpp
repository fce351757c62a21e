// SPDX-License-Identifier: MIT
#include "support/distances.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "planish/measures/metrics.hpp"
#include "support/scenes.hpp"

namespace planish::testing {

double distance(const Eigen::Vector3d& p, const Segment& s) {
  const Eigen::Vector3d along = s[1] - s[0];
  const double place = std::clamp(along.dot(p - s[0]) / along.squaredNorm(), 0.0, 1.0);
  return (s[0] + place * along - p).norm();
}

double distance(const Segment& s, const Segment& t) {
  double least =
      std::min({distance(s[0], t), distance(s[1], t), distance(t[0], s), distance(t[1], s)});
  const Eigen::Vector3d u = s[1] - s[0], v = t[1] - t[0], w = s[0] - t[0];
  const double whole = u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v);
  if (whole <= 1e-14 * u.squaredNorm() * v.squaredNorm()) return least;
  const double first = (u.dot(v) * v.dot(w) - v.squaredNorm() * u.dot(w)) / whole;
  const double second = (u.squaredNorm() * v.dot(w) - u.dot(v) * u.dot(w)) / whole;
  if (first < 0.0 || first > 1.0 || second < 0.0 || second > 1.0) return least;
  return std::min(least, (w + first * u - second * v).norm());
}

double distance_inside(const Eigen::Vector3d& p, const Eigen::Matrix3d& triangle) {
  const Eigen::Vector3d u = triangle.col(1) - triangle.col(0),
                        v = triangle.col(2) - triangle.col(0);
  const Eigen::Vector3d normal = u.cross(v), way = p - triangle.col(0);
  if (!(normal.norm() > 1e-12 * u.norm() * v.norm())) return INFINITY;
  const double second = way.cross(v).dot(normal) / normal.squaredNorm();
  const double third = u.cross(way).dot(normal) / normal.squaredNorm();
  if (second < 0.0 || third < 0.0 || second + third > 1.0) return INFINITY;
  return std::abs(way.dot(normal)) / normal.norm();
}

namespace {

/// Of the sides of `a` from the triangles of `b`, and whether one goes through.
double distance_to_triangles(const Positions& a, const Positions& b) {
  double least = INFINITY;
  for (Eigen::Index k = 1; k + 1 < b.cols(); ++k) {
    Eigen::Matrix3d triangle;
    triangle << b.col(0), b.col(k), b.col(k + 1);
    const Eigen::Vector3d u = triangle.col(1) - triangle.col(0);
    const Eigen::Vector3d normal = u.cross(triangle.col(2) - triangle.col(0));
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
      const Eigen::Vector3d p = a.col(j), q = a.col((j + 1) % a.cols());
      least = std::min(least, distance_inside(p, triangle));
      const double here = normal.dot(p - triangle.col(0)), there = normal.dot(q - triangle.col(0));
      if (here * there >= 0.0) continue;
      const Eigen::Vector3d crossing = p + here / (here - there) * (q - p);
      if (distance_inside(crossing, triangle) < INFINITY) return 0.0;
    }
  }
  return least;
}

Positions shape(const Mesh& mesh, const Positions& points, int face) {
  const auto corners = mesh.face(face);
  return points(Eigen::all, std::vector<int>(corners.begin(), corners.end()));
}

bool share_a_point(const Mesh& mesh, int f, int g) {
  const auto a = mesh.face(f), b = mesh.face(g);
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

/// Around a panel.
struct Bounds {
  Eigen::Vector3d low, high;
};

std::vector<Bounds> bounds_of_panels(const Mesh& mesh, const Positions& points) {
  std::vector<Bounds> all;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const Positions here = shape(mesh, points, f);
    all.push_back({here.rowwise().minCoeff(), here.rowwise().maxCoeff()});
  }
  return all;
}

/// Along the axis where the two are farthest apart.
double apart(const Bounds& a, const Bounds& b) {
  return (b.low - a.high).cwiseMax(a.low - b.high).maxCoeff();
}

}  // namespace

double panel_distance(const Positions& a, const Positions& b) {
  double least = std::min(distance_to_triangles(a, b), distance_to_triangles(b, a));
  for (Eigen::Index k = 0; k < a.cols(); ++k) {
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
      least = std::min(least, distance(Segment{a.col(k), a.col((k + 1) % a.cols())},
                                       Segment{b.col(j), b.col((j + 1) % b.cols())}));
    }
  }
  return least;
}

double least_panel_distance(const Mesh& base, const Positions& after, double within,
                            double clearance) {
  const std::vector<Bounds> bounds = bounds_of_panels(base, after);
  double least = INFINITY;
  for (std::size_t f = 0; f < bounds.size(); ++f) {
    const int face = static_cast<int>(f);
    const Positions here = shape(base, after, face), was = shape(base, base.positions, face);
    if (here == was) continue;
    for (std::size_t g = 0; g < bounds.size(); ++g) {
      const int other = static_cast<int>(g);
      if (apart(bounds[f], bounds[g]) > within || share_a_point(base, face, other)) continue;
      if (panel_distance(was, shape(base, base.positions, other)) < clearance) continue;
      least = std::min(least, panel_distance(here, shape(base, after, other)));
    }
  }
  return least / mean_edge_length(base);
}

}  // namespace planish::testing
