// SPDX-License-Identifier: MIT
#include "families/smallest_circle.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace planish {
namespace {

struct Circle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double squared = std::numeric_limits<double>::infinity();
  std::vector<Eigen::Vector2d> rim;  ///< the points that it is the smallest circle of
};

/// Rounding, relative to what is compared.
constexpr double kSlack = 1.0 + 1e-9;

Circle around(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return {0.5 * (a + b), 0.25 * (a - b).squaredNorm(), {a, b}};
}

/// The circle through three points; infinite where they are on a line.
Circle around(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a, v = c - a;
  const double doubled = 2.0 * (u.x() * v.y() - u.y() * v.x());
  const double uu = u.squaredNorm(), vv = v.squaredNorm();
  const Eigen::Vector2d from_a(v.y() * uu - u.y() * vv, u.x() * vv - v.x() * uu);
  if (!(std::abs(doubled) > 1e-14 * (uu + vv))) return {};
  return {a + from_a / doubled, (from_a / doubled).squaredNorm(), {a, b, c}};
}

void keep_smaller(const Circle& candidate, const std::vector<Eigen::Vector2d>& points,
                  Circle& best) {
  if (!(candidate.squared < best.squared)) return;
  for (const Eigen::Vector2d& p : points) {
    if ((p - candidate.centre).squaredNorm() > kSlack * candidate.squared) return;
  }
  best = candidate;
}

/// The smallest circle of up to four points, by trying all pairs and triples.
Circle of_few(const std::vector<Eigen::Vector2d>& points) {
  Circle best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      keep_smaller(around(points[i], points[j]), points, best);
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        keep_smaller(around(points[i], points[j], points[k]), points, best);
      }
    }
  }
  return best;
}

}  // namespace

Eigen::Vector2d smallest_circle_centre(const Eigen::Matrix2Xd& given) {
  // Coordinates about one of the points, so that rounding is that of their distances.
  const Eigen::Matrix2Xd points = given.colwise() - Eigen::Vector2d(given.col(0));
  // The farthest point joins those on the rim until none is outside: each circle is larger than the
  // one before, so that no rim comes twice; rounding is what the limit is for.
  constexpr int kMostPivots = 100;
  Circle circle{points.col(0), 0.0, {points.col(0)}};
  for (int pivot = 0; pivot < kMostPivots; ++pivot) {
    Eigen::Index far = 0;
    const double squared =
        (points.colwise() - circle.centre).colwise().squaredNorm().maxCoeff(&far);
    if (!(squared > kSlack * circle.squared)) break;
    std::vector<Eigen::Vector2d> rim = circle.rim;
    rim.emplace_back(points.col(far));
    const Circle larger = of_few(rim);
    if (!(larger.squared > circle.squared) || !std::isfinite(larger.squared)) break;
    circle = larger;
  }
  return circle.centre + given.col(0);
}

}  // namespace planish
