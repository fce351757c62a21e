// SPDX-License-Identifier: MIT
/// Rectangles on sheets: arranged in rows, not nested.
#pragma once

#include <vector>

namespace planish {

/// The gap between panels on a sheet and along its edge, metres.
inline constexpr double kSheetSpacing = 0.010;

struct SheetSize {
  double width = 0.0, height = 0.0;
  double spacing = 0.0;  ///< between rectangles, and to the edge of the sheet
};

struct SheetItem {
  double width = 0.0, height = 0.0;
};

/// Where an item lies.
struct SheetPlace {
  int sheet = -1;           ///< −1: larger than a sheet either way
  double x = 0.0, y = 0.0;  ///< of its lower left corner
  bool turned = false;      ///< by a quarter turn: its height lies along x
};

/// First fit by decreasing height: each item, the highest first, goes into the first row with room,
/// else starts a row on the first sheet with room, else a sheet. Places in the order of `items`.
[[nodiscard]] std::vector<SheetPlace> arrange_on_sheets(const std::vector<SheetItem>& items,
                                                        const SheetSize& sheet);

}  // namespace planish
