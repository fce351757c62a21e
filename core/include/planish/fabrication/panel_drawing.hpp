// SPDX-License-Identifier: MIT
/// One panel as it is cut: its outline less the joints, its name, those of its neighbours.
#pragma once

#include <optional>

#include "planish/fabrication/cutting_plan.hpp"
#include "planish/fabrication/drawing.hpp"

namespace planish {

/// `outline` with every side moved inwards by `distance`, neighbours intersected; nullopt where a
/// side would vanish or sides would cross, or where the outline crosses itself already.
[[nodiscard]] std::optional<Outline> inset(const Outline& outline, double distance);

/// A panel ready for a sheet.
struct PanelDrawing {
  Outline cut;      ///< what is cut
  Drawing drawing;  ///< with its texts and marks, in the panel's own coordinates
};

/// nullopt if the gap leaves nothing of the panel.
[[nodiscard]] std::optional<PanelDrawing> draw_panel(const CuttingPlan& plan, int face);

}  // namespace planish
