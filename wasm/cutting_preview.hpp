// SPDX-License-Identifier: MIT
/// What a cutting package would hold, without writing it: quick enough to follow the options.
#pragma once

#include <string>
#include <vector>

#include "planish/fabrication/cutting_plan.hpp"

namespace planish {

/// The figures are those of write_cutting_package(); faces by their index.
struct CuttingPreview {
  int panels = 0, drawn = 0;
  int outline = 0, bevel = 0;  ///< panels, against the base; 0 without one
  int nodes_moved = 0, nodes_arms = 0;
  double flatness = 0.0;  ///< of the worst panel, mm/m
  double excess = 0.0;    ///< the same, less what rounding accounts for: see FacePlanarity
  std::vector<int> vanished, oversize;
  int sheets = 0;
  double used_fraction = 0.0;  ///< cut area over the area of all sheets; 0 without sheets
  std::string map;             ///< SVG; "" if it was not wanted
  int shown = -1;              ///< the panel in `drawing`; −1: none is drawn
  std::string drawing;         ///< SVG of that panel
};

/// @param face the panel to show, if it is drawn; else the first that is
[[nodiscard]] CuttingPreview preview_cutting(const CuttingPlan& plan, int face, bool with_map);

}  // namespace planish
