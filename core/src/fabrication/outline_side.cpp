// SPDX-License-Identifier: MIT
#include "fabrication/outline_side.hpp"

#include <algorithm>

namespace planish {
namespace {

/// Whether ends lie on both sides by more than rounding: sides that lie in one line do not cross
/// it.
bool on_both_sides(const OutlineSide& line, const OutlineSide& other) {
  constexpr double kRounding = 1e-12;
  const double from = turn_of(line.along, other.from - line.from);
  const double to = turn_of(line.along, other.to - line.from);
  const double extent = line.length + other.length + (other.from - line.from).norm();
  return std::min(from, to) < -kRounding * extent && std::max(from, to) > kRounding * extent;
}

bool cross_each_other(const OutlineSide& a, const OutlineSide& b) {
  return on_both_sides(a, b) && on_both_sides(b, a);
}

/// How near the sides come to each other; those that follow each other: but for where they meet.
double clearance_of(const OutlineSide& a, const OutlineSide& b, bool follows) {
  const double open = std::min(distance_to(b, a.from), distance_to(a, b.to));
  if (follows) return open;
  if (cross_each_other(a, b)) return 0.0;
  return std::min({open, distance_to(b, a.to), distance_to(a, b.from)});
}

}  // namespace

double turn_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Eigen::Vector2d left_of(const Eigen::Vector2d& along) { return {-along.y(), along.x()}; }

std::vector<OutlineSide> sides_of(const Outline& outline) {
  std::vector<OutlineSide> sides;
  for (Eigen::Index k = 0; k < outline.cols(); ++k) {
    const Eigen::Vector2d from = outline.col(k), to = outline.col((k + 1) % outline.cols());
    const double length = (to - from).norm();
    if (!(length > 0.0)) continue;
    sides.push_back({from, to, (to - from) / length, length, static_cast<int>(k)});
  }
  return sides;
}

double distance_to(const OutlineSide& side, const Eigen::Vector2d& p) {
  const Eigen::Vector2d from = p - side.from;
  return (from - std::clamp(side.along.dot(from), 0.0, side.length) * side.along).norm();
}

bool has_crossing(const std::vector<OutlineSide>& sides) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 2; j < sides.size(); ++j) {
      if (cross_each_other(sides[i], sides[j])) return true;
    }
  }
  return false;
}

bool is_simple(const std::vector<OutlineSide>& sides, double clearance) {
  const std::size_t n = sides.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool closes = i == 0 && j == n - 1;
      const OutlineSide& first = closes ? sides[j] : sides[i];
      const OutlineSide& second = closes ? sides[i] : sides[j];
      if (!(clearance_of(first, second, closes || j == i + 1) > clearance)) return false;
    }
  }
  return true;
}

}  // namespace planish
