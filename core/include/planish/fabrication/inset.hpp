// SPDX-License-Identifier: MIT
/// What a joint leaves of a panel: its outline with every side moved inwards.
#pragma once

#include <vector>

#include "planish/fabrication/flat_panel.hpp"

namespace planish {

/// One piece to cut. It neither crosses nor touches itself.
struct CutPiece {
  Outline corners;         ///< anticlockwise; corner 0 is the one nearest to the panel's corner 0
  std::vector<int> sides;  ///< which of the panel's sides its side k runs along; −1 for none
};

/// What is left of `outline` when every side moves inwards by `distance` and is cut with its
/// neighbours: all that a strip of that width along each side, mitred at reflex corners, does not
/// cover. Sides may go, and the panel may fall apart; the piece nearest to corner 0 comes first.
/// Empty where nothing is left, or where the outline crosses itself already.
[[nodiscard]] std::vector<CutPiece> inset(const Outline& outline, double distance);

/// Area of all pieces together.
[[nodiscard]] double area_of(const std::vector<CutPiece>& pieces);

/// Corners of all pieces together.
[[nodiscard]] Outline corners_of(const std::vector<CutPiece>& pieces);

}  // namespace planish
