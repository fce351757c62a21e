// SPDX-License-Identifier: MIT
#include "planish/fabrication/panel_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fabrication/neighbours.hpp"
#include "planish/index.hpp"
#include "trigonometry.hpp"

namespace planish {
namespace {

double turn_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Eigen::Vector2d side_at(const Outline& outline, Eigen::Index k) {
  return outline.col((k + 1) % outline.cols()) - outline.col(k);
}

bool on_both_sides(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p,
                   const Eigen::Vector2d& q) {
  return turn_between(b - a, p - a) * turn_between(b - a, q - a) < 0.0;
}

bool has_crossing(const Outline& outline) {
  const Eigen::Index n = outline.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = i + 2; j < n; ++j) {
      const Eigen::Vector2d a = outline.col(i), b = outline.col((i + 1) % n);
      const Eigen::Vector2d p = outline.col(j), q = outline.col((j + 1) % n);
      if (on_both_sides(a, b, p, q) && on_both_sides(p, q, a, b)) return true;
    }
  }
  return false;
}

bool is_inside(const Outline& outline, const Eigen::Vector2d& p) {
  bool inside = false;
  for (Eigen::Index k = 0; k < outline.cols(); ++k) {
    const Eigen::Vector2d a = outline.col(k), b = outline.col((k + 1) % outline.cols());
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const double x = a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y());
    if (p.x() < x) inside = !inside;
  }
  return inside;
}

/// Distance from `p` to the nearest side.
double clearance(const Outline& outline, const Eigen::Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < outline.cols(); ++k) {
    const Eigen::Vector2d side = side_at(outline, k), from = p - outline.col(k);
    const double length = side.squaredNorm();
    const double along = length > 0.0 ? std::clamp(side.dot(from) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (from - along * side).norm());
  }
  return nearest;
}

Eigen::Vector2d centroid(const Outline& outline) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0.0;
  for (Eigen::Index k = 1; k + 1 < outline.cols(); ++k) {
    const Eigen::Vector2d a = outline.col(k) - outline.col(0),
                          b = outline.col(k + 1) - outline.col(0);
    const double area = turn_between(a, b);
    sum += area * (a + b) / 3.0;
    weight += area;
  }
  if (!(std::abs(weight) > 0.0)) return outline.rowwise().mean();
  return outline.col(0) + sum / weight;
}

/// A point well inside: the centroid, or of the middles of three corners the one with most room.
Eigen::Vector2d label_point(const Outline& outline) {
  const Eigen::Vector2d middle = centroid(outline);
  if (is_inside(outline, middle)) return middle;
  Eigen::Vector2d best = middle;
  double room = -1.0;
  const Eigen::Index n = outline.cols();
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Vector2d p =
        (outline.col(k) + outline.col((k + 1) % n) + outline.col((k + 2) % n)) / 3.0;
    if (!is_inside(outline, p) || clearance(outline, p) <= room) continue;
    best = p;
    room = clearance(outline, p);
  }
  return best;
}

/// Height at which `text` is not wider than `width`; a character is 0.9 of its height wide or less.
double fitting_height(const std::string& text, double width, double height) {
  return std::min(height, width / (0.9 * static_cast<double>(text.size())));
}

/// As it was asked for, but not above `most`; `otherwise` if it was not.
double text_height(const CuttingPlan& plan, double otherwise, double most) {
  return plan.options.text_height > 0.0 ? std::min(plan.options.text_height, most) : otherwise;
}

void add_names(Drawing& drawing, const CuttingPlan& plan, int face, const Outline& cut) {
  const std::string name = panel_name(face);
  const Eigen::Vector2d middle = label_point(cut);
  const double room = clearance(cut, middle);
  const double height = fitting_height(name, 1.2 * room, text_height(plan, 0.4 * room, 0.4 * room));
  drawing.texts.push_back({middle, height, 0.0, name});
  const std::string side = "OUTSIDE UP " + plan.options.unit;
  const double small = fitting_height(side, 1.2 * room, 0.5 * height);
  drawing.texts.push_back({middle - Eigen::Vector2d(0.0, height), small, 0.0, side});
}

/// Inside each side, read from the inside.
void add_neighbours(Drawing& drawing, const CuttingPlan& plan, int face, const Outline& cut,
                    double largest) {
  for (Eigen::Index k = 0; k < cut.cols(); ++k) {
    const int neighbour = panel_beyond(plan, face, static_cast<int>(k));
    if (neighbour < 0) continue;
    const std::string name = panel_name(neighbour);
    const Eigen::Vector2d side = side_at(cut, k);
    const double length = side.norm();
    const double height = fitting_height(name, 0.6 * length, largest);
    const Eigen::Vector2d inwards = Eigen::Vector2d(-side.y(), side.x()) / length;
    drawing.texts.push_back({cut.col(k) + 0.5 * side + 1.1 * height * inwards, height,
                             arctangent(side.y(), side.x()) * 180.0 / kPi, name});
  }
}

/// A triangle in corner 0.
Outline notch(const Outline& cut, double size) {
  const Eigen::Index n = cut.cols();
  const Eigen::Vector2d out = side_at(cut, 0), in = -side_at(cut, n - 1);
  const double reach = std::min({size, 0.2 * out.norm(), 0.2 * in.norm()});
  Outline triangle(2, 3);
  triangle << cut.col(0), cut.col(0) + reach * out.normalized(),
      cut.col(0) + reach * in.normalized();
  return triangle;
}

}  // namespace

std::optional<Outline> inset(const Outline& outline, double distance) {
  if (has_crossing(outline)) return std::nullopt;
  if (distance == 0.0) return outline;
  constexpr double kSpike = 1e-6;
  const Eigen::Index n = outline.cols();
  Outline result(2, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Vector2d in = side_at(outline, (k + n - 1) % n).normalized();
    const Eigen::Vector2d out = side_at(outline, k).normalized();
    const double opening = 1.0 + in.dot(out);
    if (!(opening > kSpike)) return std::nullopt;  // the sides lie on each other
    const Eigen::Vector2d sum(-in.y() - out.y(), in.x() + out.x());
    result.col(k) = outline.col(k) + distance / opening * sum;
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!(side_at(result, k).dot(side_at(outline, k)) > 0.0)) return std::nullopt;
  }
  if (!(area_of(result) > 0.0) || has_crossing(result)) return std::nullopt;
  return result;
}

std::optional<PanelDrawing> draw_panel(const CuttingPlan& plan, int face) {
  const Outline& whole = plan.panels[at(face)].outline;
  auto cut = inset(whole, 0.5 * plan.options.gap);
  if (!cut) return std::nullopt;
  PanelDrawing panel{*std::move(cut), {}};
  const double size = bounding_rectangle(panel.cut).height;
  panel.drawing.loops.push_back({DrawingLayer::kCut, panel.cut});
  if (plan.options.gap > 0.0) panel.drawing.loops.push_back({DrawingLayer::kGap, whole});
  panel.drawing.loops.push_back({DrawingLayer::kMark, notch(panel.cut, 0.1 * size)});
  add_names(panel.drawing, plan, face, panel.cut);
  add_neighbours(panel.drawing, plan, face, panel.cut, text_height(plan, 0.05 * size, 0.12 * size));
  return panel;
}

}  // namespace planish
