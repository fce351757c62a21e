// SPDX-License-Identifier: MIT
#include "planish/measures/panel_health.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "numeric/trigonometry.hpp"
#include "planish/constraints/corner_shape.hpp"

namespace planish {
namespace {

constexpr std::size_t kMostTested = 256;

using Outline = std::vector<Eigen::Vector2d>;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The corners in the plane across the area vector.
Outline flatten(const Positions& positions, std::span<const int> face) {
  const Eigen::Vector3d origin = positions.col(face[0]);
  Eigen::Vector3d normal = area_vector(positions, face);
  if (normal.isZero(0.0)) {  // a symmetric bow-tie has no area: any two edges span its plane
    for (std::size_t k = 1; k + 1 < face.size() && normal.isZero(0.0); ++k) {
      const Eigen::Vector3d a = positions.col(face[k]) - origin;
      normal = a.cross(positions.col(face[k + 1]) - origin);
    }
  }
  if (normal.isZero(0.0)) normal = Eigen::Vector3d::UnitZ();
  normal.normalize();
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Outline outline;
  for (const int vertex : face) {
    const Eigen::Vector3d p = positions.col(vertex) - origin;
    outline.emplace_back(p.dot(u), p.dot(v));
  }
  return outline;
}

bool separates(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p,
               const Eigen::Vector2d& q) {
  return cross(b - a, p - a) * cross(b - a, q - a) < 0.0;
}

bool crosses_itself(const Outline& outline) {
  const std::size_t n = outline.size();
  if (n > kMostTested) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % n];
    for (std::size_t j = i + 2; j < n; ++j) {
      const Eigen::Vector2d &p = outline[j], &q = outline[(j + 1) % n];
      if (separates(a, b, p, q) && separates(p, q, a, b)) return true;
    }
  }
  return false;
}

/// Whether a face leaves nothing to make a panel of.
bool is_collapsed(const Positions& positions, std::span<const int> face, double shortest_edge) {
  constexpr double kThin = 1e-3;
  double longest = 0.0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const int next = face[(k + 1) % face.size()];
    longest = std::max(longest, (positions.col(next) - positions.col(face[k])).norm());
  }
  const double width = 0.5 * area_vector(positions, face).norm() / longest;
  return !(shortest_edge > kThin * longest && width > kThin * longest);
}

/// How far each corner turns, radians, positive the way that the outline turns as a whole.
struct Turns {
  std::vector<double> corners;
  bool once = true;  ///< all of them together go round once
};

Turns turns_of(const Outline& outline) {
  const std::size_t n = outline.size();
  Turns turns;
  double total = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const Eigen::Vector2d in = outline[k] - outline[(k + n - 1) % n];
    const Eigen::Vector2d out = outline[(k + 1) % n] - outline[k];
    turns.corners.push_back(std::atan2(cross(in, out), in.dot(out)));
    total += turns.corners.back();
  }
  const double way = total < 0.0 ? -1.0 : 1.0;
  for (double& turn : turns.corners) turn *= way;
  turns.once = std::abs(std::abs(total) - 2.0 * kPi) < 0.1;
  return turns;
}

/// A corner in the middle of an edge turns by rounding only.
constexpr double kRoundingTurn = 1e-9;

/// Concave only where corners that were straight turned by what the bound lets them. [SHP-1]
bool is_nearly_convex(const Turns& before, const Turns& after) {
  constexpr double kDegree = kPi / 180.0;
  if (!after.once) return false;
  for (std::size_t k = 0; k < after.corners.size(); ++k) {
    const bool straight = std::abs(before.corners[k]) <= kStraight;
    if (after.corners[k] <= (straight ? -kDegree : -kRoundingTurn)) return false;
  }
  return true;
}

}  // namespace

PanelHealth panel_health(const Positions& positions, std::span<const int> face) {
  const Outline outline = flatten(positions, face);
  const Turns turns = turns_of(outline);
  PanelHealth health;
  health.shortest_edge = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const double edge = (outline[(k + 1) % outline.size()] - outline[k]).norm();
    health.shortest_edge = std::min(health.shortest_edge, edge);
  }
  const double widest = *std::max_element(turns.corners.begin(), turns.corners.end());
  const double least = *std::min_element(turns.corners.begin(), turns.corners.end());
  health.smallest_angle = std::min(360.0, (kPi - widest) * 180.0 / kPi);
  if (!(least > -kRoundingTurn) || !turns.once) {
    health.outline = crosses_itself(outline) ? PanelOutline::kSelfCrossing : PanelOutline::kConcave;
  }
  return health;
}

PanelDamage panel_damage(const Positions& before, const Positions& after,
                         std::span<const int> face) {
  const PanelHealth was = panel_health(before, face);
  const PanelHealth is = panel_health(after, face);
  if (is.outline == PanelOutline::kSelfCrossing) {
    return was.outline == is.outline ? PanelDamage::kNone : PanelDamage::kSelfCrossing;
  }
  const bool had_a_side = was.outline != PanelOutline::kSelfCrossing;
  if (had_a_side && area_vector(before, face).dot(area_vector(after, face)) < 0.0) {
    return PanelDamage::kTurnedOver;
  }
  if (is_collapsed(after, face, is.shortest_edge) &&
      !is_collapsed(before, face, was.shortest_edge)) {
    return PanelDamage::kCollapsed;
  }
  const bool dented =
      was.outline == PanelOutline::kConvex && is.outline == PanelOutline::kConcave &&
      !is_nearly_convex(turns_of(flatten(before, face)), turns_of(flatten(after, face)));
  return dented ? PanelDamage::kConcave : PanelDamage::kNone;
}

bool became_sliver(const Positions& before, const Positions& after, std::span<const int> face) {
  return panel_health(after, face).smallest_angle < kSliverAngle &&
         panel_health(before, face).smallest_angle >= kSliverAngle;
}

int count_new_slivers(const Mesh& mesh, const Positions& before, const Positions& after) {
  int count = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const bool changed =
        std::any_of(face.begin(), face.end(), [&](int v) { return after.col(v) != before.col(v); });
    if (changed && panel_damage(before, after, face) == PanelDamage::kNone &&
        became_sliver(before, after, face)) {
      ++count;
    }
  }
  return count;
}

}  // namespace planish
