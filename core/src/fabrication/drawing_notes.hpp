// SPDX-License-Identifier: MIT
/// What stands round a view of the structure: axes, levels, where sections cut, sizes and a title.
#pragma once

#include <string>
#include <vector>

#include "fabrication/view_axes.hpp"
#include "planish/fabrication/drawing.hpp"
#include "planish/fabrication/drawing_axis.hpp"
#include "planish/fabrication/section.hpp"

namespace planish {

/// Where a section cuts.
struct SectionMark {
  SectionPlane plane;  ///< in the drawing's unit
  std::string number;
};

struct DrawingNotes {
  std::vector<DrawingAxis> axes;  ///< in the drawing's unit
  std::vector<SectionMark> sections;
  std::string unit;       ///< the drawing's: of sizes
  double levels = 0.001;  ///< units of levels (metres, feet) in one of it
  std::string title;      ///< the line below
};

/// The notes of a view of what lies in `box`. What is seen edge-on is drawn: axes with their name
/// in a circle, levels with their height, sections with an arrow along which they are seen. Sizes
/// are of the whole, and from axis to axis.
/// @param paper one millimetre of paper, in the drawing's unit
[[nodiscard]] Drawing notes_round(const PlanarBox& box, const ViewAxes& view,
                                  const DrawingNotes& notes, double paper);

/// The box of a drawing with its texts, whose widths are estimated.
[[nodiscard]] PlanarBox box_of(const Drawing& drawing);

}  // namespace planish
