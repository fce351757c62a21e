// SPDX-License-Identifier: MIT
/// A new line of points through a strip of quads.
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "cuts/chord.hpp"
#include "cuts/cut_operations.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// A side that the line crosses: `near` is where shares are counted from.
struct CrossedSide {
  int near = 0, far = 0;

  friend bool operator==(const CrossedSide&, const CrossedSide&) = default;
};

/// Quads one after the other, one that the strip crosses itself in twice, and the sides between and
/// around them: one side more than quads, unless it is closed.
struct Strip {
  std::vector<int> quads;
  std::vector<CrossedSide> sides;
  bool is_closed = false;
};

/// The side of a quad that lies opposite.
CrossedSide opposite(std::span<const int> quad, const CrossedSide& side) {
  const auto k =
      static_cast<std::size_t>(std::find(quad.begin(), quad.end(), side.near) - quad.begin());
  const bool forward = quad[(k + 1) % 4] == side.far;
  return {quad[(k + (forward ? 3 : 1)) % 4], quad[(k + 2) % 4]};
}

/// Goes on from the last side of `strip` through panel f and beyond, until it ends or is closed.
Refusal follow(const PanelNet& net, int f, double share, Strip& strip) {
  const CrossedSide first = strip.sides.front();
  while (f >= 0 && net.panel(f).size() == 4) {
    const CrossedSide next = opposite(net.panel(f), strip.sides.back());
    strip.quads.push_back(f);
    const bool is_turned = next == CrossedSide{first.far, first.near};
    if (is_turned && share != 0.5) {
      return "the strip comes back to its side turned over, where only the share 0.5 fits";
    }
    strip.is_closed = is_turned || next == first;
    if (strip.is_closed) return std::nullopt;
    strip.sides.push_back(next);
    const auto panels = net.panels_at(next.near, next.far);
    f = panels[0] == f ? panels[1] : panels[0];
  }
  return std::nullopt;
}

/// The whole strip, from one of its ends to the other.
Refusal find_strip(const PanelNet& net, const CrossedSide& side, double share, Strip& strip) {
  const auto panels = net.panels_at(side.near, side.far);
  strip.sides = {side};
  if (Refusal problem = follow(net, panels[0], share, strip)) return problem;
  if (strip.is_closed) return std::nullopt;
  std::reverse(strip.sides.begin(), strip.sides.end());
  std::reverse(strip.quads.begin(), strip.quads.end());
  return follow(net, panels[1], share, strip);
}

/// Parts panel f between two points on its outline; the part with `near` keeps the number.
Refusal part_panel(PanelNet& net, int f, int entry, int exit, int near) {
  const std::vector<int> outline = outline_between(net, f, entry, exit);
  const bool is_near = std::find(outline.begin(), outline.end(), near) != outline.end();
  return part_along_chord(net, f, is_near ? entry : exit, is_near ? exit : entry);
}

/// The strip on its way through the panels, its points there already.
class StripLine {
 public:
  StripLine(const Strip& strip, const std::vector<int>& points, double share)
      : strip_(strip), points_(points), share_(share), others_(strip.quads.size(), -1) {}

  /// Parts the k-th quad.
  Refusal part(PanelNet& net, std::size_t k) {
    const auto earlier = std::find(strip_.quads.begin(), strip_.quads.end(), strip_.quads[k]);
    const auto first = static_cast<std::size_t>(earlier - strip_.quads.begin());
    if (first < k) return cross(net, first, k);
    others_[k] = net.panel_count();
    return part_panel(net, strip_.quads[k], points_[k], exit_point(k), strip_.sides[k].near);
  }

 private:
  [[nodiscard]] std::size_t exit_of(std::size_t k) const { return (k + 1) % points_.size(); }
  [[nodiscard]] int exit_point(std::size_t k) const { return points_[exit_of(k)]; }

  /// Parts both parts of a quad that the strip went through before, as its `first`. Lines between
  /// opposite sides at shares s and t meet at the share s of one, which is t of the other.
  Refusal cross(PanelNet& net, std::size_t first, std::size_t k) const {
    const CrossedSide entry = strip_.sides[k], exit = strip_.sides[exit_of(k)];
    const CrossedSide before = strip_.sides[first];
    const bool along = entry.near == before.near || entry.near == before.far;
    const int middle =
        net.add_on_edge(points_[first], exit_point(first), along ? share_ : 1.0 - share_);
    const auto part_with = [&](int point) {
      return net.corner_of(strip_.quads[k], point) >= 0 ? strip_.quads[k] : others_[first];
    };
    const int entered = part_with(points_[k]), left = part_with(exit_point(k));
    if (Refusal problem = part_panel(net, entered, points_[k], middle, entry.near)) return problem;
    return part_panel(net, left, middle, exit_point(k), exit.near);
  }

  const Strip& strip_;
  const std::vector<int>& points_;
  double share_;
  std::vector<int> others_;  ///< the new panel that each quad was parted into
};

}  // namespace

Refusal apply_cut(const StripCut& cut, PanelNet& net) {
  const auto panels = net.panels_at(cut.from, cut.to);
  const std::string side =
      "the side from " + std::to_string(cut.from) + " to " + std::to_string(cut.to);
  if (panels[0] < 0) return "no panel has " + side;
  Strip strip;
  if (Refusal problem = find_strip(net, {cut.from, cut.to}, cut.share, strip)) return problem;
  if (strip.quads.empty()) return "no quad has " + side;
  std::vector<int> points;
  for (const CrossedSide& crossed : strip.sides) {
    points.push_back(net.add_on_edge(crossed.near, crossed.far, cut.share));
  }
  StripLine line(strip, points, cut.share);
  for (std::size_t k = 0; k < strip.quads.size(); ++k) {
    if (Refusal problem = line.part(net, k)) return problem;
  }
  return std::nullopt;
}

}  // namespace planish
