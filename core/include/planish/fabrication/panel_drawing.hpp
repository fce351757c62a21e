// SPDX-License-Identifier: MIT
/// One panel as it is cut: its outline less the joints, its name, those of its neighbours.
#pragma once

#include <optional>
#include <vector>

#include "planish/fabrication/cutting_plan.hpp"
#include "planish/fabrication/drawing.hpp"
#include "planish/fabrication/inset.hpp"

namespace planish {

/// A panel ready for a sheet.
struct PanelDrawing {
  std::vector<CutPiece> pieces;  ///< what is cut; more than one if the gap takes a neck
  Drawing drawing;               ///< with its texts and marks, in the panel's own coordinates
};

/// nullopt if the gap leaves nothing of the panel.
[[nodiscard]] std::optional<PanelDrawing> draw_panel(const CuttingPlan& plan, int face);

/// The template of a type of plan.types, with its name and how many are cut: as a panel, but
/// without neighbours, which every panel of the type has of its own.
/// @param faces what is cut from it. nullopt if the gap leaves nothing
[[nodiscard]] std::optional<PanelDrawing> draw_template(const CuttingPlan& plan, int type,
                                                        const std::vector<int>& faces);

/// What a panel takes on a sheet where `spacing` stays free around it: the rectangle of what is
/// cut, larger where the panel's outline before the gap stands out of it by more than that.
[[nodiscard]] BoundingRectangle room_on_sheet(const PanelDrawing& panel, double spacing);

}  // namespace planish
