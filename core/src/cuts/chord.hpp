// SPDX-License-Identifier: MIT
/// Lines through a panel from corner to corner.
#pragma once

#include <vector>

#include "cuts/panel_net.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

/// Why panel f cannot be parted along the line between two of its corners: they are neighbours, the
/// line runs along the outline or leaves the panel, or it is a side of other panels. Seen along the
/// panel's normal; lines that meet within 1e-9 of the line's length, or of a right angle's sine,
/// touch.
[[nodiscard]] Refusal find_problem_of_chord(const PanelNet& net, int f, int start, int end);

/// Parts panel f along such a line. What its outline from `start` to `end` bounds keeps the number.
[[nodiscard]] Refusal part_along_chord(PanelNet& net, int f, int start, int end);

/// The corners of panel f from one to another, both included, in its order.
[[nodiscard]] std::vector<int> outline_between(const PanelNet& net, int f, int start, int end);

/// "panel 7".
[[nodiscard]] std::string panel_text(int f);

}  // namespace planish
