// SPDX-License-Identifier: MIT
/// What a cutting package would hold, without writing it: quick enough to follow the options.
#pragma once

#include <string>

#include "planish/fabrication/cutting_package.hpp"

namespace planish {

/// The figures are those of write_cutting_package(); faces by their index.
struct CuttingPreview : CuttingReport {
  int panels = 0;
  int outline = 0, bevel = 0;  ///< panels, against the base; 0 without one
  int nodes_moved = 0, nodes_arms = 0;
  int types = 0;        ///< of panels; 0 where they were not asked for
  std::string map;      ///< SVG; "" if it was not wanted
  std::string shown;    ///< the panel or type in `drawing`; "": none is drawn
  std::string drawing;  ///< SVG of it
};

/// @param face the panel to show, or its type, if it is drawn; else the first that is
[[nodiscard]] CuttingPreview preview_cutting(const CuttingPlan& plan, int face, bool with_map);

}  // namespace planish
