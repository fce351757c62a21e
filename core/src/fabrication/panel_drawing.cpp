// SPDX-License-Identifier: MIT
#include "planish/fabrication/panel_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "fabrication/neighbours.hpp"
#include "numeric/trigonometry.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

double turn_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Eigen::Vector2d side_at(const Outline& outline, Eigen::Index k) {
  return outline.col((k + 1) % outline.cols()) - outline.col(k);
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

/// Height at which `text` is not wider than `width`.
double fitting_height(const std::string& text, double width, double height) {
  return std::min(height, width / text_width(text, 1.0));
}

/// The rectangle that `text` fills at most; `along`: as it runs, of length 1.
Outline room_of(const DrawnText& text, const Eigen::Vector2d& along) {
  const Eigen::Vector2d up(-along.y(), along.x());
  const Eigen::Vector2d right = 0.5 * text_width(text.text, text.height) * along;
  const Eigen::Vector2d top = 0.5 * text.height * up;
  Outline corners(2, 4);
  corners << -right - top, right - top, right + top, top - right;
  return corners.colwise() + text.position;
}

/// Whether all of `b` lies beyond one side of `a`, which is convex and runs anticlockwise.
bool is_beyond_a_side(const Outline& a, const Outline& b) {
  for (Eigen::Index k = 0; k < a.cols(); ++k) {
    bool beyond = true;
    for (const auto p : b.colwise()) {
      beyond = beyond && turn_between(side_at(a, k), p - a.col(k)) < 0.0;
    }
    if (beyond) return true;
  }
  return false;
}

bool do_meet(const Outline& a, const Outline& b) {
  return !is_beyond_a_side(a, b) && !is_beyond_a_side(b, a);
}

/// What is drawn on a panel so far, so that nothing is drawn over it.
struct TakenRoom {
  const Outline& cut;
  std::vector<Outline> taken;

  /// Whether the rectangle lies on the panel and is free.
  [[nodiscard]] bool has(const Outline& room) const {
    for (const auto p : room.colwise()) {
      if (!is_inside(cut, p)) return false;
    }
    for (const auto p : cut.colwise()) {  // of a concave panel a corner may stand in the rectangle
      if (is_inside(room, p)) return false;
    }
    return std::none_of(taken.begin(), taken.end(),
                        [&](const Outline& other) { return do_meet(room, other); });
  }
};

/// The height of text that was asked for, but not above `most`; `otherwise` if it was not.
double text_height(const CuttingPlan& plan, double otherwise, double most) {
  return plan.options.text_height > 0.0 ? std::min(plan.options.text_height, most) : otherwise;
}

/// A name, and smaller below it which side is up.
void add_names(Drawing& drawing, const CuttingPlan& plan, const std::string& name,
               const std::string& side, TakenRoom& room_left) {
  const Outline& cut = room_left.cut;
  const Eigen::Vector2d middle = label_point(cut);
  const double room = clearance(cut, middle);
  const double height = fitting_height(name, 1.2 * room, text_height(plan, 0.4 * room, 0.4 * room));
  drawing.texts.push_back({middle, height, 0.0, name});
  const double small = fitting_height(side, 1.2 * room, 0.5 * height);
  drawing.texts.push_back({middle - Eigen::Vector2d(0.0, height), small, 0.0, side});
  for (std::size_t k = drawing.texts.size() - 2; k < drawing.texts.size(); ++k) {
    room_left.taken.push_back(room_of(drawing.texts[k], Eigen::Vector2d::UnitX()));
  }
}

constexpr double kSmaller = 0.85;
constexpr int kTries = 30;  // to 1/130 of the size, which then stands whatever it meets

/// The panel beyond each side of a piece; below 0 there is none.
std::vector<int> neighbours_along(const CuttingPlan& plan, int face, const CutPiece& piece) {
  std::vector<int> neighbours;
  for (const int side : piece.sides) {
    neighbours.push_back(side < 0 ? -1 : panel_beyond(plan, face, side));
  }
  return neighbours;
}

/// Adds the neighbour's name inside each side, read from the inside; smaller where there is no
/// room, as in acute corners.
void add_neighbours(Drawing& drawing, const PanelNames& names, const std::vector<int>& neighbours,
                    double largest, TakenRoom& room_left) {
  const Outline& cut = room_left.cut;
  for (Eigen::Index k = 0; k < cut.cols(); ++k) {
    const int neighbour = neighbours[at(k)];
    if (neighbour < 0) continue;
    const Eigen::Vector2d side = side_at(cut, k);
    const Eigen::Vector2d middle = cut.col(k) + 0.5 * side, along = side / side.norm();
    const Eigen::Vector2d inwards(-along.y(), along.x());
    DrawnText text;
    text.text = names.of(neighbour);
    text.degrees = arctangent(side.y(), side.x()) * 180.0 / kPi;
    text.height = fitting_height(text.text, 0.6 * side.norm(), largest);
    text.position = middle + 1.1 * text.height * inwards;
    for (int tries = 0; tries < kTries && !room_left.has(room_of(text, along)); ++tries) {
      text.height *= kSmaller;
      text.position = middle + 1.1 * text.height * inwards;
    }
    room_left.taken.push_back(room_of(text, along));
    drawing.texts.push_back(std::move(text));
  }
}

/// A triangle that points at corner 0, on the panel and clear of what is cut: no line is to be both
/// engraved and cut.
Outline corner_mark(const Outline& cut, double size) {
  const Eigen::Index n = cut.cols();
  const Eigen::Vector2d corner = cut.col(0), out = side_at(cut, 0), in = -side_at(cut, n - 1);
  const double reach = std::min({size, 0.2 * out.norm(), 0.2 * in.norm()});
  const Eigen::Vector2d a = out.normalized(), b = in.normalized();
  Outline triangle(2, 3);
  constexpr double kStraight = 0.2;  // sine: a triangle between the sides would have no area
  if (turn_between(a, b) > kStraight || (turn_between(a, b) > 0.0 && a.dot(b) > 0.0)) {
    triangle << corner, corner + reach * a, corner + reach * b;
    const Eigen::Vector2d middle = triangle.rowwise().mean();
    return (0.6 * triangle).colwise() + 0.4 * middle;
  }
  const Eigen::Vector2d inwards = Eigen::Vector2d(b.y() - a.y(), a.x() - b.x()).normalized();
  const Eigen::Vector2d across(inwards.y(), -inwards.x());
  triangle << corner + 0.2 * reach * inwards, corner + reach * (0.8 * inwards + 0.3 * across),
      corner + reach * (0.8 * inwards - 0.3 * across);
  return triangle;
}

void add_corner_mark(Drawing& drawing, double size, TakenRoom& room_left) {
  Outline mark = corner_mark(room_left.cut, size);
  for (int tries = 0; tries < kTries && !room_left.has(mark); ++tries) {
    mark = corner_mark(room_left.cut, size *= kSmaller);
  }
  room_left.taken.push_back(mark);
  drawing.loops.push_back({DrawingLayer::kMark, std::move(mark)});
}

/// How high the names of neighbours are at most on `piece`.
double neighbour_height(const CuttingPlan& plan, const CutPiece& piece) {
  const double size = bounding_rectangle(piece.corners).height;
  return text_height(plan, 0.05 * size, 0.12 * size);
}

/// `whole` less the joints, with its texts but for those that `add_more` adds to each piece.
template <class AddMore>
std::optional<PanelDrawing> draw_outline(const CuttingPlan& plan, const Outline& whole,
                                         const std::string& name, const std::string& side,
                                         const AddMore& add_more) {
  PanelDrawing panel{inset(whole, 0.5 * plan.options.gap), {}};
  if (panel.pieces.empty()) return std::nullopt;
  for (const CutPiece& piece : panel.pieces) {
    panel.drawing.loops.push_back({DrawingLayer::kCut, piece.corners});
  }
  if (plan.options.gap > 0.0) panel.drawing.loops.push_back({DrawingLayer::kGap, whole});
  for (const CutPiece& piece : panel.pieces) {
    const double size = bounding_rectangle(piece.corners).height;
    TakenRoom room_left{piece.corners, {}};
    add_names(panel.drawing, plan, name, side, room_left);
    if (&piece == &panel.pieces.front()) add_corner_mark(panel.drawing, 0.1 * size, room_left);
    add_more(panel.drawing, piece, room_left);
  }
  return panel;
}

}  // namespace

std::optional<PanelDrawing> draw_panel(const CuttingPlan& plan, int face) {
  const auto add_more = [&](Drawing& drawing, const CutPiece& piece, TakenRoom& room_left) {
    add_neighbours(drawing, plan.options.names, neighbours_along(plan, face, piece),
                   neighbour_height(plan, piece), room_left);
  };
  return draw_outline(plan, plan.panels[at(face)].outline, plan.options.names.of(face),
                      "OUTSIDE UP " + plan.options.unit, add_more);
}

std::optional<PanelDrawing> draw_template(const CuttingPlan& plan, int type,
                                          const std::vector<int>& faces) {
  const PanelTypes& types = plan.types->panels;
  const auto turned = std::count_if(faces.begin(), faces.end(),
                                    [&](int face) { return types.panels[at(face)].mirrored; });
  std::string side = std::to_string(faces.size()) + " IN ALL ";
  side += turned == 0 ? "OUTSIDE UP " : std::to_string(turned) + " TURNED OVER ";
  return draw_outline(plan, types.types[at(type)].outline, type_name(type),
                      side + plan.options.unit, [](Drawing&, const CutPiece&, TakenRoom&) {});
}

BoundingRectangle room_on_sheet(const PanelDrawing& panel, double spacing) {
  BoundingRectangle room = bounding_rectangle(corners_of(panel.pieces));
  for (const DrawnLoop& loop : panel.drawing.loops) {
    if (loop.layer == DrawingLayer::kGap) room = widened(room, loop.points, spacing);
  }
  return room;
}

}  // namespace planish
