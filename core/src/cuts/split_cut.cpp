// SPDX-License-Identifier: MIT
/// Cuts along one line through one panel: splits and corners.
#include <algorithm>
#include <string>

#include "cuts/chord.hpp"
#include "cuts/cut_operations.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

Refusal find_problem_of_place(const PanelNet& net, int f, const OutlinePlace& place) {
  const std::string from = std::to_string(place.vertex);
  if (place.to < 0) {
    if (net.corner_of(f, place.vertex) >= 0) return std::nullopt;
    return panel_text(f) + " has no corner " + from;
  }
  if (net.has_side(f, place.vertex, place.to)) return std::nullopt;
  return panel_text(f) + " has no side from " + from + " to " + std::to_string(place.to);
}

bool are_on_one_side(const OutlinePlace& a, const OutlinePlace& b) {
  return a.to >= 0 && b.to >= 0 && std::minmax(a.vertex, a.to) == std::minmax(b.vertex, b.to);
}

/// The corner at `place`, which is added where it is on a side.
int corner_at(PanelNet& net, const OutlinePlace& place) {
  return place.to < 0 ? place.vertex : net.add_on_edge(place.vertex, place.to, place.share);
}

}  // namespace

Refusal find_problem_of_panel(const PanelNet& net, int f) {
  if (f < net.panel_count()) return std::nullopt;
  return "there is no " + panel_text(f) + ": panels are 0 to " +
         std::to_string(net.panel_count() - 1);
}

Refusal apply_cut(const SplitCut& cut, PanelNet& net) {
  if (Refusal problem = find_problem_of_panel(net, cut.panel)) return problem;
  if (Refusal problem = find_problem_of_place(net, cut.panel, cut.start)) return problem;
  if (Refusal problem = find_problem_of_place(net, cut.panel, cut.end)) return problem;
  if (are_on_one_side(cut.start, cut.end)) {
    return "A and B are on one side of " + panel_text(cut.panel);
  }
  const int start = corner_at(net, cut.start);
  const int end = corner_at(net, cut.end);
  return part_along_chord(net, cut.panel, start, end);
}

Refusal apply_cut(const CornerCut& cut, PanelNet& net) {
  if (Refusal problem = find_problem_of_panel(net, cut.panel)) return problem;
  const auto corners = net.panel(cut.panel);
  const int count = static_cast<int>(corners.size()), k = net.corner_of(cut.panel, cut.vertex);
  if (k < 0) return panel_text(cut.panel) + " has no corner " + std::to_string(cut.vertex);
  if (count == 3 && cut.share == 1.0) {
    return panel_text(cut.panel) + " is a triangle, of which a share T below 1 can be cut off";
  }
  const auto place = [&](int neighbour) {
    return cut.share == 1.0 ? OutlinePlace{neighbour}
                            : OutlinePlace{cut.vertex, neighbour, cut.share};
  };
  // What goes round from the next corner to the one before keeps the number.
  return apply_cut(SplitCut{cut.panel, place(corners[at((k + 1) % count)]),
                            place(corners[at((k + count - 1) % count)])},
                   net);
}

}  // namespace planish
