// SPDX-License-Identifier: MIT
#include "planish/fabrication/flat_panel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/trigonometry.hpp"

namespace planish {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Eigen::Vector2d side_of(const Outline& outline, Eigen::Index side) {
  return outline.col((side + 1) % outline.cols()) - outline.col(side);
}

/// Convex hull, anticlockwise (Andrew's monotone chain).
std::vector<Eigen::Vector2d> hull_of(const Outline& outline) {
  std::vector<Eigen::Vector2d> points;
  for (Eigen::Index k = 0; k < outline.cols(); ++k) points.emplace_back(outline.col(k));
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Eigen::Vector2d> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const Eigen::Vector2d& p : points) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The rectangle around `points` whose width is along `along`.
BoundingRectangle rectangle_along(const std::vector<Eigen::Vector2d>& points,
                                  const Eigen::Vector2d& along) {
  const Eigen::Vector2d up(-along.y(), along.x());
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d place(along.dot(p), up.dot(p));
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  return {low.x() * along + low.y() * up, along, high.x() - low.x(), high.y() - low.y()};
}

/// The rectangle `r` with its width as the longer side.
BoundingRectangle lengthwise(const BoundingRectangle& r) {
  if (r.width >= r.height) return r;
  const Eigen::Vector2d up(-r.along.y(), r.along.x());
  return {r.corner + r.width * r.along, up, r.height, r.width};
}

}  // namespace

FlatPanel flatten_panel(const Positions& positions, std::span<const int> face, int x_side) {
  FlatPanel panel;
  panel.frame = panel_frame(positions, face, x_side);
  panel.outline.resize(2, static_cast<Eigen::Index>(face.size()));
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Eigen::Vector3d p = panel.frame.to_panel(positions.col(face[k]));
    panel.outline.col(static_cast<Eigen::Index>(k)) = p.head<2>();
    panel.off_plane.push_back(p.z());
  }
  return panel;
}

double area_of(const Outline& outline) {
  double doubled = 0.0;
  for (Eigen::Index k = 1; k + 1 < outline.cols(); ++k) {
    doubled += cross(outline.col(k) - outline.col(0), outline.col(k + 1) - outline.col(0));
  }
  return 0.5 * doubled;
}

double side_length(const Outline& outline, Eigen::Index side) {
  return side_of(outline, side).norm();
}

double interior_angle(const Outline& outline, Eigen::Index corner) {
  const Eigen::Vector2d in = side_of(outline, (corner + outline.cols() - 1) % outline.cols());
  const Eigen::Vector2d out = side_of(outline, corner);
  return kPi - arctangent(cross(in, out), in.dot(out));
}

BoundingRectangle bounding_rectangle(const Outline& outline) {
  const std::vector<Eigen::Vector2d> hull = hull_of(outline);
  BoundingRectangle best = rectangle_along(hull, Eigen::Vector2d::UnitX());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Eigen::Vector2d side = hull[(k + 1) % hull.size()] - hull[k];
    if (!(side.norm() > 0.0)) continue;
    const BoundingRectangle here = rectangle_along(hull, side.normalized());
    // Equal up to rounding counts as equal: the first one stays.
    if (here.width * here.height < least * (1.0 - 1e-9)) {
      best = here;
      least = here.width * here.height;
    }
  }
  return lengthwise(best);
}

BoundingRectangle widened(const BoundingRectangle& r, const Outline& outline, double margin) {
  constexpr double kRounding = 1e-9;  // of what stands out by the margin itself
  const double free = (1.0 + kRounding) * margin;
  const Eigen::Vector2d up(-r.along.y(), r.along.x());
  const Outline from = outline.colwise() - r.corner;
  const Eigen::RowVectorXd x = r.along.transpose() * from, y = up.transpose() * from;
  const double left = std::min(0.0, x.minCoeff() + free);
  const double low = std::min(0.0, y.minCoeff() + free);
  const double right = std::max(r.width, x.maxCoeff() - free);
  const double top = std::max(r.height, y.maxCoeff() - free);
  return lengthwise({r.corner + left * r.along + low * up, r.along, right - left, top - low});
}

std::vector<int> setting_out_corners(const Outline& outline) {
  Eigen::Index far = 0;
  (outline.colwise() - outline.col(0)).colwise().squaredNorm().maxCoeff(&far);
  const Eigen::Vector2d line = outline.col(far) - outline.col(0);
  Eigen::Index aside = 0;
  double farthest = -1.0;
  for (Eigen::Index k = 0; k < outline.cols(); ++k) {
    const double distance = std::abs(cross(line, outline.col(k) - outline.col(0)));
    if (k == 0 || k == far || distance <= farthest) continue;
    farthest = distance;
    aside = k;
  }
  return {0, static_cast<int>(far), static_cast<int>(aside)};
}

}  // namespace planish
