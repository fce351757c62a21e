// SPDX-License-Identifier: MIT
#include "cutting_preview.hpp"

#include <algorithm>
#include <utility>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/fabrication/assembly_map.hpp"
#include "planish/fabrication/drawing.hpp"
#include "planish/fabrication/panel_drawing.hpp"
#include "planish/fabrication/sheet_layout.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kMargin = 0.03;  ///< around a panel, of its longer side

/// A panel by itself, moved to where a picture begins.
std::string picture_of(const PanelDrawing& panel, const std::string& unit) {
  const Outline cut = corners_of(panel.pieces);
  Eigen::Array2d low = cut.rowwise().minCoeff();
  Eigen::Array2d high = cut.rowwise().maxCoeff();
  for (const DrawnLoop& loop : panel.drawing.loops) {
    low = low.min(loop.points.rowwise().minCoeff().array());
    high = high.max(loop.points.rowwise().maxCoeff().array());
  }
  const double margin = kMargin * (high - low).maxCoeff();
  PlanarMotion motion;
  motion.shift = (margin - low).matrix();
  Drawing picture;
  add_moved(picture, panel.drawing, motion);
  const Eigen::Array2d size = high - low + 2.0 * margin;
  return write_svg(picture, size.x(), size.y(), unit);
}

/// Panels that are drawn: what a sheet has to know of each.
struct DrawnPanels {
  std::vector<int> faces;
  std::vector<SheetItem> items;
  std::vector<double> areas;
};

double spacing_of(const CuttingOptions& options) {
  return kSheetSpacing / metres_in(options.unit).value();
}

DrawnPanels draw_panels(const CuttingPlan& plan, int face, CuttingPreview& preview) {
  const double spacing = spacing_of(plan.options);
  DrawnPanels drawn;
  for (int f = 0; f < plan.mesh.face_count(); ++f) {
    if (plan.drawn[at(f)] == 0) continue;
    const auto panel = draw_panel(plan, f);
    if (!panel) {
      preview.vanished.push_back(f);
      continue;
    }
    const BoundingRectangle rectangle = room_on_sheet(*panel, spacing);
    note_pieces(plan, f, panel->pieces, preview);
    drawn.faces.push_back(f);
    drawn.items.push_back({rectangle.width, rectangle.height});
    drawn.areas.push_back(area_of(panel->pieces));
    if (preview.shown >= 0 && f != face) continue;
    preview.shown = f;
    preview.drawing = picture_of(*panel, plan.options.unit);
  }
  preview.drawn = static_cast<int>(drawn.faces.size());
  return drawn;
}

void fill_sheets(const CuttingOptions& options, const DrawnPanels& drawn, CuttingPreview& preview) {
  const SheetSize size{options.sheet_width, options.sheet_height, spacing_of(options)};
  const auto places = arrange_on_sheets(drawn.items, size);
  double area = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    preview.sheets = std::max(preview.sheets, places[k].sheet + 1);
    if (places[k].sheet < 0) {
      preview.oversize.push_back(drawn.faces[k]);
    } else {
      area += drawn.areas[k];
    }
  }
  if (preview.sheets > 0)
    preview.used_fraction = area / (preview.sheets * size.width * size.height);
}

}  // namespace

CuttingPreview preview_cutting(const CuttingPlan& plan, int face, bool with_map) {
  CuttingPreview preview;
  preview.panels = plan.mesh.face_count();
  for (int f = 0; f < preview.panels; ++f) {
    const FacePlanarity planarity = face_planarity(plan.mesh.positions, plan.mesh.face(f));
    preview.flatness = std::max(preview.flatness, planarity.mm_per_m);
    preview.excess = std::max(preview.excess, planarity.excess);
  }
  if (plan.remake) {
    preview.outline = plan.remake->count(PanelChange::kOutline);
    preview.bevel = plan.remake->count(PanelChange::kBevel);
    preview.nodes_moved = plan.remake->count(NodeChange::kMoved);
    preview.nodes_arms = plan.remake->count(NodeChange::kArms);
  }
  const DrawnPanels drawn = draw_panels(plan, face, preview);
  if (plan.options.sheet_width > 0.0) fill_sheets(plan.options, drawn, preview);
  if (with_map) preview.map = write_assembly_map(plan);
  return preview;
}

}  // namespace planish
