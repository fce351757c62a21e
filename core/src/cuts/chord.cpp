// SPDX-License-Identifier: MIT
#include "cuts/chord.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kTouch = 1e-9;

/// The line between two corners of a panel, seen along the panel's normal.
class Chord {
 public:
  Chord(const PanelNet& net, int f, int start, int end)
      : net_(net),
        corners_(net.panel(f)),
        normal_(net.area_vector(f).normalized()),
        start_(net.point(start)),
        along_(net.point(end) - start_),
        first_(net.corner_of(f, start)),
        last_(net.corner_of(f, end)) {}

  /// Whether one of its ends leaves along a side there.
  [[nodiscard]] bool runs_along_side() const {
    return is_along_side(first_, along_) || is_along_side(last_, -along_);
  }

  /// Whether both its ends leave into the panel.
  [[nodiscard]] bool starts_inside() const {
    return is_inside_corner(first_, along_) && is_inside_corner(last_, -along_);
  }

  /// Whether a corner lies on it or a side crosses it; its ends and their sides aside.
  [[nodiscard]] bool is_crossed() const {
    const int count = static_cast<int>(corners_.size());
    for (int k = 0; k < count; ++k) {
      const int next = (k + 1) % count;
      if (k == first_ || k == last_) continue;
      if (is_on(corner(k))) return true;
      if (next != first_ && next != last_ && crosses(corner(k), corner(next))) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] Eigen::Vector3d corner(int k) const { return net_.point(corners_[at(k)]); }
  [[nodiscard]] double turn(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    return normal_.dot(a.cross(b));
  }
  /// The sine of the angle from a to b.
  [[nodiscard]] double sine(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    return turn(a.normalized(), b.normalized());
  }

  /// The sides from a corner to the next one and to the one before.
  [[nodiscard]] std::array<Eigen::Vector3d, 2> sides_at(int k) const {
    const int count = static_cast<int>(corners_.size());
    return {corner((k + 1) % count) - corner(k), corner((k + count - 1) % count) - corner(k)};
  }

  [[nodiscard]] bool is_along_side(int k, const Eigen::Vector3d& direction) const {
    const auto sides = sides_at(k);
    return std::any_of(sides.begin(), sides.end(), [&](const Eigen::Vector3d& side) {
      return side.dot(direction) > 0.0 && std::abs(sine(side, direction)) <= kTouch;
    });
  }

  [[nodiscard]] bool is_inside_corner(int k, const Eigen::Vector3d& direction) const {
    const auto [out, in] = sides_at(k);
    const double from_out = sine(out, direction), to_in = sine(direction, in);
    if (sine(out, in) > kTouch) return from_out > kTouch && to_in > kTouch;
    if (sine(out, in) < -kTouch) return from_out > kTouch || to_in > kTouch;
    // A straight corner; or a spike, of which no direction is inside.
    return out.dot(in) < 0.0 && from_out > kTouch && to_in > kTouch;
  }

  [[nodiscard]] bool is_on(const Eigen::Vector3d& place) const {
    const Eigen::Vector3d to_place = place - start_;
    const double share = to_place.dot(along_) / along_.squaredNorm();
    return share > -kTouch && share < 1.0 + kTouch &&
           std::abs(turn(along_, to_place)) <= kTouch * along_.squaredNorm();
  }

  [[nodiscard]] bool crosses(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    const bool apart = (turn(along_, a - start_) > 0.0) != (turn(along_, b - start_) > 0.0);
    return apart && (turn(b - a, start_ - a) > 0.0) != (turn(b - a, start_ + along_ - a) > 0.0);
  }

  const PanelNet& net_;
  std::span<const int> corners_;
  Eigen::Vector3d normal_, start_, along_;
  int first_, last_;
};

}  // namespace

std::string panel_text(int f) { return "panel " + std::to_string(f); }

Refusal find_problem_of_chord(const PanelNet& net, int f, int start, int end) {
  const auto line = [&] {
    return "the line from point " + std::to_string(start) + " to " + std::to_string(end);
  };
  if (net.has_side(f, start, end)) {
    return "points " + std::to_string(start) + " and " + std::to_string(end) +
           " are neighbours on the outline of " + panel_text(f);
  }
  if (net.panels_at(start, end)[0] >= 0) return line() + " is a side of other panels already";
  if (!(net.area_vector(f).norm() > 0.0)) return panel_text(f) + " encloses no area";
  const Chord chord(net, f, start, end);
  if (chord.runs_along_side()) return line() + " runs along the outline of " + panel_text(f);
  if (!chord.starts_inside() || chord.is_crossed()) {
    return line() + " leaves " + panel_text(f) + ", which is not convex";
  }
  return std::nullopt;
}

Refusal part_along_chord(PanelNet& net, int f, int start, int end) {
  if (Refusal problem = find_problem_of_chord(net, f, start, end)) return problem;
  net.part(f, {outline_between(net, f, start, end), outline_between(net, f, end, start)});
  return std::nullopt;
}

std::vector<int> outline_between(const PanelNet& net, int f, int start, int end) {
  const auto corners = net.panel(f);
  std::vector<int> outline;
  for (std::size_t k = at(net.corner_of(f, start));; k = (k + 1) % corners.size()) {
    outline.push_back(corners[k]);
    if (corners[k] == end) return outline;
  }
}

}  // namespace planish
