// SPDX-License-Identifier: MIT
/// Plan, elevations and sections of the whole structure, to scale, as one zip of SVG and DXF.
#pragma once

#include <string>
#include <vector>

#include "planish/fabrication/drawing_axis.hpp"
#include "planish/fabrication/panel_names.hpp"
#include "planish/fabrication/section.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

struct DrawingOptions {
  std::string name = "structure";  ///< for people; what was drawn
  std::string model_unit = "m";    ///< of the mesh: mm, cm, m, km, in or ft
  std::string unit = "mm";         ///< of DXF and of the section's points: the same words
  double scale = 0.0;  ///< of the SVG, 1 : scale; 0: the first usual one that fits A3, 420 × 297 mm
  bool own_scales = false;  ///< without `scale`: each drawing the first at which it fits alone
  std::vector<SectionPlane> sections;  ///< offsets in model units
  std::vector<DrawingAxis> axes;       ///< beside the levels of the lowest and the highest point
  PanelNames names;                    ///< of the mesh that is drawn
};

/// The first rule that `options` breaks, naming its field; nullopt if none.
[[nodiscard]] Refusal find_problem(const DrawingOptions& options);

/// The first rule that `options` breaks for `mesh`, of which axes too far off would show nothing.
[[nodiscard]] Refusal find_problem(const DrawingOptions& options, const Mesh& mesh);

struct StructureDrawings {
  std::string zip;          ///< see docs/fabrication.md
  std::string header;       ///< drawings.json
  std::vector<int> missed;  ///< sections, counted from 0, that do not meet the structure
};

/// @param mesh must have passed check_mesh(); @param options must have no problem with it
[[nodiscard]] StructureDrawings write_drawings(const Mesh& mesh, const DrawingOptions& options);

}  // namespace planish
