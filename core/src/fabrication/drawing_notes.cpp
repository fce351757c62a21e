// SPDX-License-Identifier: MIT
#include "fabrication/drawing_notes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "numeric/trigonometry.hpp"

namespace planish {
namespace {

using Eigen::Vector2d;

// Millimetres of paper, from the structure outwards.
constexpr double kBeyond = 4.0;       // lines go on past the structure
constexpr double kChain = 10.0;       // sizes from axis to axis
constexpr double kWhole = 17.0;       // the size of the whole
constexpr double kBubble = 27.0;      // circles with names of axes
constexpr double kRadius = 4.0;       // of such a circle
constexpr double kRow = 9.0;          // between two rows of them
constexpr double kLevel = 12.0;       // where the height of a level begins
constexpr double kTitle = 8.0;        // below all else
constexpr double kTextHeight = 2.5;   // of capitals
constexpr double kTitleHeight = 3.5;  // the same

Outline line(const Vector2d& from, const Vector2d& to) {
  Outline points(2, 2);
  points << from, to;
  return points;
}

Outline circle(const Vector2d& centre, double radius) {
  constexpr int kSides = 24;
  Outline points(2, kSides);
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * kPi * k / kSides;
    points.col(k) = centre + radius * Vector2d(cosine(angle), sine(angle));
  }
  return points;
}

/// A line that something is seen as: the points p with normal · p = offset.
struct SeenLine {
  Vector2d normal, along;  ///< unit; `along` is right or up, more or less
  double offset = 0.0;
};

/// nullopt where it is not seen edge-on.
std::optional<SeenLine> edge_on(const ViewAxes& view, const Eigen::Vector3d& normal,
                                double offset) {
  constexpr double kTilted = 1e-9;
  if (std::abs(normal.dot(view.towards)) > kTilted) return std::nullopt;
  const Vector2d seen = view.seen(normal);
  Vector2d along(-seen.y(), seen.x());
  if (along.x() + along.y() < 0.0) along = -along;
  return SeenLine{seen, along, offset};
}

class Notes {
 public:
  Notes(const PlanarBox& box, const ViewAxes& view, const DrawingNotes& notes, double paper)
      : box_(box), frame_(box), view_(view), notes_(notes), paper_(paper) {
    for (const DrawingAxis& axis : notes.axes) {
      const auto seen = edge_on(view, Eigen::Vector3d::Unit(axis.coordinate), axis.at);
      if (!seen) continue;
      const int k = std::abs(seen->normal.x()) > 0.5 ? 0 : 1;
      const double at = seen->offset * seen->normal[k];
      frame_.low[k] = std::min(frame_.low[k], at);
      frame_.high[k] = std::max(frame_.high[k], at);
      if (axis.coordinate != 2)
        axes_[static_cast<std::size_t>(k)].push_back({at, *seen, axis.name});
    }
    for (auto& axes : axes_) {
      std::stable_sort(axes.begin(), axes.end(),
                       [](const SeenAxis& a, const SeenAxis& b) { return a.at < b.at; });
    }
  }

  Drawing write() {
    if ((box_.high - box_.low).maxCoeff() > 0.0) {
      for (const auto& axes : axes_) add_axes(axes);
      for (const SectionMark& mark : notes_.sections) add_section(mark);
      add_levels();
      for (int k = 0; k < 2; ++k) add_sizes(k);
    }
    add_title();
    return std::move(drawing_);
  }

 private:
  void draw(DrawingLayer layer, Outline points, bool closed = false) {
    drawing_.loops.push_back({layer, std::move(points), closed});
  }

  void write_text(const Vector2d& position, std::string text, double height = kTextHeight,
                  double degrees = 0.0) {
    drawing_.texts.push_back({position, height * paper_, degrees, std::move(text)});
  }

  /// An axis by its place along x or y.
  struct SeenAxis {
    double at = 0.0;
    SeenLine line;
    std::string name;
  };

  /// The stretch of `seen` beside the structure and all axes and levels, `before` and `after`
  /// millimetres longer.
  std::pair<Vector2d, Vector2d> stretch(const SeenLine& seen, double before, double after) const {
    const Vector2d foot = seen.offset * seen.normal;
    double low = 0.0, high = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
      const Vector2d p((corner & 1) != 0 ? frame_.high.x() : frame_.low.x(),
                       (corner & 2) != 0 ? frame_.high.y() : frame_.low.y());
      const double at_corner = seen.along.dot(p);
      low = corner == 0 ? at_corner : std::min(low, at_corner);
      high = corner == 0 ? at_corner : std::max(high, at_corner);
    }
    return {foot + (low - before * paper_) * seen.along,
            foot + (high + after * paper_) * seen.along};
  }

  /// Circles that would touch stand in two rows.
  void add_axes(const std::vector<SeenAxis>& axes) {
    double before = -std::numeric_limits<double>::infinity();
    bool second = false;
    for (const SeenAxis& axis : axes) {
      const bool close = axis.at - before < 2.2 * kRadius * paper_;
      second = close && !second;
      before = axis.at;
      add_axis(axis, kBubble + (second ? kRow : 0.0));
    }
  }

  void add_axis(const SeenAxis& axis, double away) {
    const auto [begin, end] = stretch(axis.line, away - kRadius, kBeyond);
    draw(DrawingLayer::kAxis, line(begin, end));
    if (axis.name.empty()) return;
    const Vector2d outwards = -axis.line.along;
    const Vector2d centre = begin + kRadius * paper_ * outwards;
    draw(DrawingLayer::kAxis, circle(centre, kRadius * paper_), true);
    constexpr double kLegible = 1.8;
    const double fits = std::min(kTextHeight, 1.6 * kRadius / text_width(axis.name, 1.0));
    if (fits >= kLegible) return write_text(centre, axis.name, fits);
    const double half = std::abs(outwards.x()) * 0.5 * text_width(axis.name, kTextHeight);
    write_text(centre + (kRadius + half + kTextHeight) * paper_ * outwards, axis.name);
  }

  void add_section(const SectionMark& mark) {
    const auto seen = edge_on(view_, mark.plane.normal, mark.plane.offset);
    if (!seen) return;
    constexpr double kLength = 8.0, kArrow = 5.0, kHead = 1.2;
    // Beyond the sizes, and the circles of axes that run the same way.
    const bool upright = std::abs(seen->normal.x()) > 0.5;
    const bool circles = !axes_[upright ? 0 : 1].empty();
    const double before = circles ? kBubble + kRow + kRadius : kWhole + kBeyond;
    const auto [begin, end] = stretch(*seen, before, kBeyond);
    for (const auto& [at_end, outwards] :
         {std::pair(begin, Vector2d(-seen->along)), std::pair(end, seen->along)}) {
      const Vector2d far = at_end + kLength * paper_ * outwards;
      const Vector2d tip = far - kArrow * paper_ * seen->normal;
      draw(DrawingLayer::kPlane, line(at_end, far));
      draw(DrawingLayer::kPlane, line(far, tip));
      Outline head(2, 3);
      head << tip, tip + kHead * paper_ * (2.0 * seen->normal + outwards),
          tip + kHead * paper_ * (2.0 * seen->normal - outwards);
      draw(DrawingLayer::kPlane, std::move(head), true);
      write_text(far + (kTextHeight + 1.0) * paper_ * outwards, mark.number);
    }
  }

  /// Heights, from below upwards, each clear of the one below it.
  void add_levels() {
    std::vector<DrawingAxis> levels;
    for (const DrawingAxis& axis : notes_.axes) {
      if (axis.coordinate == 2) levels.push_back(axis);
    }
    std::stable_sort(levels.begin(), levels.end(),
                     [](const DrawingAxis& a, const DrawingAxis& b) { return a.at < b.at; });
    double free = -std::numeric_limits<double>::infinity();
    for (const DrawingAxis& level : levels) {
      const auto seen = edge_on(view_, Eigen::Vector3d::UnitZ(), level.at);
      if (!seen) continue;
      const auto [begin, end] = stretch(*seen, kBeyond, kLevel);
      draw(DrawingLayer::kLevel, line(begin, end));
      const Vector2d tip = end - 2.0 * paper_ * seen->along;
      Outline mark(2, 3);
      mark << tip, tip + paper_ * Vector2d(1.2, 2.0), tip + paper_ * Vector2d(-1.2, 2.0);
      draw(DrawingLayer::kLevel, std::move(mark), true);
      std::string text = height_text(level.at);
      if (!level.name.empty()) text += ' ' + level.name;
      const double y = std::max(end.y(), free);
      free = y + 1.6 * kTextHeight * paper_;
      const double half = 0.5 * text_width(text, kTextHeight) + 1.0;
      write_text({end.x() + half * paper_, y}, std::move(text));
    }
  }

  [[nodiscard]] std::string height_text(double at) const {
    std::string text = fixed(at * notes_.levels, 3);
    return text.front() == '-' || at == 0.0 ? text : '+' + text;
  }

  /// Rounded as one reads it: no digit is left out at the end.
  static std::string fixed(double value, int decimals) {
    double power = 1.0;
    for (int k = 0; k < decimals; ++k) power *= 10.0;
    const double rounded = std::round(value * power) / power;
    std::string text;
    append_decimals(text, rounded);
    if (decimals == 0) return text;
    std::size_t point = text.find('.');
    if (point == std::string::npos) {
      point = text.size();
      text += '.';
    }
    while (text.size() - point <= static_cast<std::size_t>(decimals)) text += '0';
    return text;
  }

  [[nodiscard]] std::string size_text(double size) const {
    static constexpr std::array<std::pair<std::string_view, int>, 6> kDecimals = {
        {{"mm", 0}, {"cm", 1}, {"m", 3}, {"km", 6}, {"in", 1}, {"ft", 2}}};
    int decimals = 3;
    for (const auto& [unit, count] : kDecimals) {
      if (notes_.unit == unit) decimals = count;
    }
    return fixed(size, decimals);
  }

  /// Adds sizes along x below, along y on the left: from end to end by way of the axes, and the
  /// whole.
  void add_sizes(int k) {
    const double low = box_.low[k], high = box_.high[k];
    if (!(high > low)) return;
    std::vector<double> stops{low, high};
    for (const SeenAxis& axis : axes_[static_cast<std::size_t>(k)]) stops.push_back(axis.at);
    std::sort(stops.begin(), stops.end());
    const double least = 1e-9 * (high - low);
    const auto same = [least](double a, double b) { return b - a <= least; };
    stops.erase(std::unique(stops.begin(), stops.end(), same), stops.end());
    bool below = false;
    for (std::size_t s = 1; s < stops.size() && stops.size() > 2; ++s) {
      const double size = stops[s] - stops[s - 1];
      const bool narrow = text_width(size_text(size), kTextHeight) * paper_ > size;
      below = narrow && !below;
      add_size(k, stops[s - 1], stops[s], {kChain, below, 0.5});
    }
    add_size(k, low, high, {kWhole, false, clear_share(k, low, high)});
  }

  /// How far along a size its text stands, clear of the axes that cross it.
  [[nodiscard]] double clear_share(int k, double low, double high) const {
    const double half = 0.5 * text_width(size_text(high - low), kTextHeight) * paper_ + paper_;
    for (const double share : {0.5, 0.45, 0.55, 0.4, 0.6, 0.35, 0.65, 0.3, 0.7, 0.25, 0.75}) {
      const double middle = low + share * (high - low);
      const auto& axes = axes_[static_cast<std::size_t>(k)];
      const bool clear = std::none_of(axes.begin(), axes.end(), [&](const SeenAxis& axis) {
        return std::abs(axis.at - middle) < half;
      });
      if (clear) return share;
    }
    return 0.5;
  }

  /// Where the line of a size runs, in millimetres from the structure, and its text.
  struct SizeLine {
    double away = 0.0;
    bool below = false;  ///< the text: beyond the line
    double share = 0.5;  ///< of the size, where the text stands
  };

  void add_size(int k, double from, double to, const SizeLine& how) {
    const double across = frame_.low[1 - k] - how.away * paper_;
    const auto place = [&](double along, double out) {
      return k == 0 ? Vector2d(along, across + out * paper_)
                    : Vector2d(across + out * paper_, along);
    };
    draw(DrawingLayer::kSize, line(place(from, 0.0), place(to, 0.0)));
    for (const double stop : {from, to}) {
      draw(DrawingLayer::kSize, line(place(stop, -1.5), place(stop, 3.0)));
      const Vector2d slash = paper_ * Vector2d(1.0, 1.0);
      draw(DrawingLayer::kSize, line(place(stop, 0.0) - slash, place(stop, 0.0) + slash));
    }
    const double middle = from + how.share * (to - from);
    // Read from below, or from the right.
    const double out = (k == 0) == how.below ? -2.0 : 2.0;
    write_text(place(middle, out), size_text(to - from), kTextHeight, k == 0 ? 0.0 : 90.0);
  }

  void add_title() {
    Drawing all = drawing_;
    all.loops.push_back({DrawingLayer::kSize, line(box_.low, box_.high), false});
    const PlanarBox taken = box_of(all);
    const double half = 0.5 * text_width(notes_.title, kTitleHeight);
    write_text({taken.low.x() + half * paper_, taken.low.y() - kTitle * paper_}, notes_.title,
               kTitleHeight);
  }

  PlanarBox box_;                                ///< of the structure
  PlanarBox frame_;                              ///< with axes and levels
  std::array<std::vector<SeenAxis>, 2> axes_{};  ///< by place along x, along y
  const ViewAxes& view_;
  const DrawingNotes& notes_;
  double paper_;
  Drawing drawing_;
};

}  // namespace

Drawing notes_round(const PlanarBox& box, const ViewAxes& view, const DrawingNotes& notes,
                    double paper) {
  return Notes(box, view, notes, paper).write();
}

PlanarBox box_of(const Drawing& drawing) {
  PlanarBox box;
  bool any = false;
  const auto take = [&](const Vector2d& low, const Vector2d& high) {
    box.low = any ? Vector2d(box.low.cwiseMin(low)) : low;
    box.high = any ? Vector2d(box.high.cwiseMax(high)) : high;
    any = true;
  };
  for (const DrawnLoop& loop : drawing.loops) {
    take(loop.points.rowwise().minCoeff(), loop.points.rowwise().maxCoeff());
  }
  for (const DrawnText& text : drawing.texts) {
    const bool upright = std::abs(text.degrees) == 90.0;
    const Vector2d half(0.5 * text_width(text.text, text.height), 0.5 * text.height);
    const Vector2d reach = upright ? Vector2d(half.y(), half.x()) : half;
    take(text.position - reach, text.position + reach);
  }
  return box;
}

}  // namespace planish
