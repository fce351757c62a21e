// SPDX-License-Identifier: MIT
/// What a workshop cuts: every panel by itself, or one template a type, and the sheets for it.
#pragma once

#include <string>
#include <vector>

#include "planish/fabrication/cutting_plan.hpp"
#include "planish/fabrication/panel_drawing.hpp"
#include "planish/fabrication/sheet_layout.hpp"

namespace planish {

/// One drawing, and what is cut by it.
struct CutItem {
  std::string name;        ///< of the panel, or of the type
  std::vector<int> faces;  ///< one piece each
  PanelDrawing panel;
  BoundingRectangle rectangle;  ///< around what is cut
  BoundingRectangle room;       ///< that a piece takes on a sheet
};

/// What came of the pieces; faces by their index.
struct CuttingReport : DrawnReport {
  std::vector<int> oversize;  ///< larger than a sheet either way
  int sheets = 0;
  double used_fraction = 0.0;  ///< cut area over the area of all sheets; 0 without sheets
};

/// What the drawings of `plan` show, in the order of panels or types. Notes in `report` what is
/// drawn and what the joints leave of it.
[[nodiscard]] std::vector<CutItem> cut_items(const CuttingPlan& plan, CuttingReport& report);

/// One piece on a sheet.
struct PlacedPiece {
  int item = 0;
  SheetPlace place;  ///< of its room
};

/// Every piece of `items` on sheets of the size that `plan` asks for, which must ask for one; those
/// that fit none are left out. Notes the sheets in `report`.
std::vector<PlacedPiece> place_pieces(const CuttingPlan& plan, const std::vector<CutItem>& items,
                                      CuttingReport& report);

/// What stays free between pieces, and along the edge of a sheet, in the unit of `options`.
[[nodiscard]] double sheet_spacing(const CuttingOptions& options);

}  // namespace planish
