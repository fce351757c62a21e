// SPDX-License-Identifier: MIT
/// Panels into as many quads as they have corners, and what is beside them split to them.
#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "cuts/chord.hpp"
#include "cuts/cut_operations.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// Whether panel f is as wide as 180° at its k-th corner.
bool is_straight(const PanelNet& net, int f, std::size_t k) {
  constexpr double kStraight = 1e-6;  // rad
  const auto corners = net.panel(f);
  const Eigen::Vector3d corner = net.point(corners[k]);
  const Eigen::Vector3d out = net.point(corners[(k + 1) % corners.size()]) - corner;
  const Eigen::Vector3d in = net.point(corners[(k + corners.size() - 1) % corners.size()]) - corner;
  return out.dot(in) < 0.0 && out.cross(in).norm() <= kStraight * out.norm() * in.norm();
}

/// The corners of panel f that are not straight.
std::vector<int> true_corners(const PanelNet& net, int f) {
  std::vector<int> corners;
  for (std::size_t k = 0; k < net.panel(f).size(); ++k) {
    if (!is_straight(net, f, k)) corners.push_back(net.panel(f)[k]);
  }
  return corners;
}

/// The point about the middle between two corners: a straight corner that is there already, the
/// nearest to it, else a new one.
int middle_between(PanelNet& net, int f, int from, int to) {
  const std::vector<int> outline = outline_between(net, f, from, to);
  if (outline.size() == 2) return net.add_on_edge(from, to, 0.5);
  const Eigen::Vector3d middle = 0.5 * (net.point(from) + net.point(to));
  return *std::min_element(outline.begin() + 1, outline.end() - 1, [&](int a, int b) {
    return (net.point(a) - middle).squaredNorm() < (net.point(b) - middle).squaredNorm();
  });
}

/// Whether every side of panel f is seen from `centre` on the same hand.
bool sees_all_sides(const PanelNet& net, int f, const Eigen::Vector3d& centre) {
  constexpr double kLeast = 1e-9;  // of the area
  const Eigen::Vector3d area = net.area_vector(f);
  const auto corners = net.panel(f);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector3d a = net.point(corners[k]) - centre;
    const Eigen::Vector3d b = net.point(corners[(k + 1) % corners.size()]) - centre;
    if (!(a.cross(b).dot(area) > kLeast * area.squaredNorm())) return false;
  }
  return true;
}

Refusal refine_panel(PanelNet& net, int f) {
  const std::vector<int> corners = true_corners(net, f);
  const std::size_t count = corners.size();
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const int v : corners) centre += net.point(v) / static_cast<double>(count);
  if (count < 3 || !sees_all_sides(net, f, centre)) {
    return panel_text(f) + " is not convex enough to be refined about its middle";
  }
  std::vector<int> middles;
  for (std::size_t k = 0; k < count; ++k) {
    middles.push_back(middle_between(net, f, corners[k], corners[(k + 1) % count]));
  }
  std::vector<std::vector<int>> parts;
  const int middle = net.add_inside(f, centre);
  for (std::size_t k = 0; k < count; ++k) {
    parts.push_back(outline_between(net, f, middles[(k + count - 1) % count], middles[k]));
    parts.back().push_back(middle);
  }
  net.part(f, parts);
  return std::nullopt;
}

/// A line from a straight corner that this cut put on a side of panel f: rather to another such
/// corner, then so that the smaller part is large.
struct CollarLine {
  int start = 0, end = 0;
  bool joins_two = false;
  double smaller = 0.0;  ///< twice the area of the smaller part
};

double twice_area_of(const PanelNet& net, const std::vector<int>& outline) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = net.point(outline.front());
  for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
    area += (net.point(outline[k]) - origin).cross(net.point(outline[k + 1]) - origin);
  }
  return area.norm();
}

std::optional<CollarLine> best_collar_line(const PanelNet& net, int f) {
  const std::vector<int> corners = true_corners(net, f);
  const auto is_true = [&](int v) {
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  };
  std::optional<CollarLine> best;
  for (const int start : net.new_points_of(f)) {
    if (is_true(start)) continue;
    for (const int end : net.panel(f)) {
      if (end == start || find_problem_of_chord(net, f, start, end)) continue;
      const CollarLine line{start, end, !is_true(end) && net.is_new(end),
                            std::min(twice_area_of(net, outline_between(net, f, start, end)),
                                     twice_area_of(net, outline_between(net, f, end, start)))};
      if (!best ||
          std::tie(best->joins_two, best->smaller) < std::tie(line.joins_two, line.smaller)) {
        best = line;
      }
    }
  }
  return best;
}

/// Splits panel f until none of the points that this cut put on its sides is a straight corner.
Refusal split_to_points(PanelNet& net, int f) {
  std::vector<int> left{f};
  while (!left.empty()) {
    const int panel = left.back();
    const auto line = best_collar_line(net, panel);
    if (!line) {
      left.pop_back();
      continue;
    }
    if (Refusal problem = part_along_chord(net, panel, line->start, line->end)) return problem;
    left.push_back(net.panel_count() - 1);
  }
  return std::nullopt;
}

}  // namespace

Refusal apply_cut(const RefineCut& cut, PanelNet& net) {
  for (const int f : cut.panels) {
    if (Refusal problem = find_problem_of_panel(net, f)) return problem;
  }
  // Numbers stay: what refining appends is behind all panels.
  for (const int f : cut.panels) {
    if (Refusal problem = refine_panel(net, f)) return problem;
  }
  if (!cut.collar) return std::nullopt;
  for (const int f : net.panels_with_new_points()) {
    if (Refusal problem = split_to_points(net, f)) return problem;
  }
  return std::nullopt;
}

}  // namespace planish
