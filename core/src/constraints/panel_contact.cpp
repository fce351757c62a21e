// SPDX-License-Identifier: MIT
#include "planish/constraints/panel_contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace planish {
namespace {

PanelGap gap_along(const Eigen::Vector3d& normal, const Positions& first, const Positions& second) {
  return {normal, (normal.transpose() * first).minCoeff(),
          (normal.transpose() * second).maxCoeff()};
}

Eigen::Vector3d edge_of(const Positions& panel, Eigen::Index k) {
  return panel.col((k + 1) % panel.cols()) - panel.col(k);
}

/// Twice its area vector.
Eigen::Vector3d area_of(const Positions& panel) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 1; k < panel.cols(); ++k) {
    area += Eigen::Vector3d(panel.col(k) - panel.col(0)).cross(edge_of(panel, k));
  }
  return area;
}

double sides_squared(const Positions& panel) {
  double sum = 0.0;
  for (Eigen::Index k = 0; k < panel.cols(); ++k) sum += edge_of(panel, k).squaredNorm();
  return sum;
}

/// Takes the widest of the gaps along what it is given.
class WidestGap {
 public:
  WidestGap(const Positions& first, const Positions& second) : first_(first), second_(second) {
    widest_.lowest = -std::numeric_limits<double>::infinity();
  }

  /// @param scale of the two vectors that `axis` is the product of
  void look_along(const Eigen::Vector3d& axis, double scale) {
    constexpr double kParallel = 1e-6;
    const double length = axis.norm();
    if (!(length > kParallel * scale)) return;
    for (const double sign : {1.0, -1.0}) {
      const PanelGap gap = gap_along(sign / length * axis, first_, second_);
      if (gap.width() > widest_.width()) widest_ = gap;
    }
  }

  [[nodiscard]] const PanelGap& found() const { return widest_; }

 private:
  const Positions& first_;
  const Positions& second_;
  PanelGap widest_;
};

}  // namespace

PanelGap widest_gap(const Positions& first, const Positions& second) {
  WidestGap widest(first, second);
  for (const Positions* const panel : {&first, &second}) {
    const Eigen::Vector3d area = area_of(*panel);
    widest.look_along(area, sides_squared(*panel));
    for (Eigen::Index k = 0; k < panel->cols(); ++k) {
      const Eigen::Vector3d edge = edge_of(*panel, k);
      widest.look_along(area.cross(edge), area.norm() * edge.norm());
    }
  }
  for (Eigen::Index k = 0; k < first.cols(); ++k) {
    const Eigen::Vector3d edge = edge_of(first, k);
    for (Eigen::Index j = 0; j < second.cols(); ++j) {
      const Eigen::Vector3d other = edge_of(second, j);
      widest.look_along(edge.cross(other), edge.norm() * other.norm());
    }
  }
  return widest.found();
}

namespace {

bool one_plane_parts(const PanelPath& first, const PanelPath& second, double clearance) {
  const auto mean_move = [](const PanelPath& path) -> Eigen::Vector3d {
    return (path.now - path.base).rowwise().mean();
  };
  const Eigen::Vector3d together = 0.5 * (mean_move(first) + mean_move(second));
  const auto part = [&](const Eigen::Vector3d& normal) {
    const PanelGap base = gap_along(normal, first.base, second.base);
    const PanelGap now = gap_along(normal, first.now, second.now);
    const double moved = normal.dot(together);
    return std::min(base.lowest, now.lowest - moved) - std::max(base.highest, now.highest - moved) >
           clearance;
  };
  return part(widest_gap(first.now, second.now).normal) ||
         part(widest_gap(first.base, second.base).normal);
}

/// Whether panels stay apart on their ways, by halves of the way, each with a plane of its own.
bool are_parted(const PanelPath& first, const PanelPath& second, double clearance, int halvings) {
  if (one_plane_parts(first, second, clearance)) return true;
  if (halvings == 0) return false;
  const Positions a = 0.5 * (first.base + first.now), b = 0.5 * (second.base + second.now);
  return are_parted({first.base, a}, {second.base, b}, clearance, halvings - 1) &&
         are_parted({a, first.now}, {b, second.now}, clearance, halvings - 1);
}

}  // namespace

bool are_parted(const PanelPath& first, const PanelPath& second, double clearance) {
  constexpr int kHalvings = 5;
  return are_parted(first, second, clearance, kHalvings);
}

}  // namespace planish
