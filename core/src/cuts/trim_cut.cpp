// SPDX-License-Identifier: MIT
/// What lies beyond a plane goes, and panels that it crosses end on it.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "cuts/chord.hpp"
#include "cuts/cut_operations.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// On which side of the plane points are; those of the cut itself are on it.
class TrimSides {
 public:
  TrimSides(const TrimCut& cut, const PanelNet& net) {
    const Eigen::Vector3d direction(cut.plane[0], cut.plane[1], cut.plane[2]);
    const double length = direction.norm(), level = cut.plane[3] / length;
    const double touch = kTouchOfSide * mean_side(net);
    for (int v = 0; v < net.point_count(); ++v) {
      const double height = (direction / length).dot(net.point(v)) - level;
      heights_.push_back(std::abs(height) <= touch ? 0.0 : height);
    }
  }

  [[nodiscard]] double height(int v) const {
    return at(v) < heights_.size() ? heights_[at(v)] : 0.0;
  }
  [[nodiscard]] bool is_beyond(int v) const { return height(v) > 0.0; }

  [[nodiscard]] bool has_beyond(std::span<const int> corners) const {
    return std::any_of(corners.begin(), corners.end(), [&](int v) { return height(v) > 0.0; });
  }
  [[nodiscard]] bool has_before(std::span<const int> corners) const {
    return std::any_of(corners.begin(), corners.end(), [&](int v) { return height(v) < 0.0; });
  }

 private:
  static constexpr double kTouchOfSide = 1e-6;

  static double mean_side(const PanelNet& net) {
    double sum = 0.0, count = 0.0;
    for (int f = 0; f < net.panel_count(); ++f) {
      const auto corners = net.panel(f);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        sum += (net.point(corners[k]) - net.point(corners[(k + 1) % corners.size()])).norm();
        count += 1.0;
      }
    }
    return sum / count;
  }

  std::vector<double> heights_;  ///< one a point; 0 where it touches the plane
};

/// Puts points where the plane crosses sides of panel f.
void cross_sides(PanelNet& net, int f, const TrimSides& sides) {
  const std::vector<int> corners(net.panel(f).begin(), net.panel(f).end());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const int from = corners[k], to = corners[(k + 1) % corners.size()];
    const double here = sides.height(from), there = sides.height(to);
    if (here * there < 0.0) net.add_on_edge(from, to, here / (here - there));
  }
}

/// Panel f, whose sides end on the plane, without what is beyond it.
Refusal end_on_plane(PanelNet& net, int f, const TrimSides& sides) {
  const auto corners = net.panel(f);
  const std::size_t count = corners.size();
  int first = -1, last = -1, runs = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const int here = corners[k], next = corners[(k + 1) % count];
    if (sides.is_beyond(here) && !sides.is_beyond(next)) first = next, ++runs;
    if (!sides.is_beyond(here) && sides.is_beyond(next)) last = here;
  }
  if (runs != 1) {
    return "the plane crosses " + panel_text(f) + ", which is not convex, more than once";
  }
  if (Refusal problem = find_problem_of_chord(net, f, first, last)) return problem;
  net.part(f, {outline_between(net, f, first, last)});
  return std::nullopt;
}

}  // namespace

Refusal apply_cut(const TrimCut& cut, PanelNet& net) {
  const TrimSides sides(cut, net);
  std::vector<char> gone(at(net.panel_count()), 0);
  std::vector<int> crossed;
  for (int f = 0; f < net.panel_count(); ++f) {
    if (!sides.has_beyond(net.panel(f))) continue;
    if (sides.has_before(net.panel(f))) {
      crossed.push_back(f);
    } else {
      gone[at(f)] = 1;
    }
  }
  const auto lost = std::count(gone.begin(), gone.end(), 1);
  if (lost == 0 && crossed.empty()) return "nothing of the mesh lies beyond the plane";
  if (lost == static_cast<std::ptrdiff_t>(gone.size()))
    return "all of the mesh lies beyond the plane";
  for (const int f : crossed) cross_sides(net, f, sides);
  for (const int f : crossed) {
    if (Refusal problem = end_on_plane(net, f, sides)) return problem;
  }
  net.remove(gone);
  return std::nullopt;
}

}  // namespace planish
