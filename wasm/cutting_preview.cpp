// SPDX-License-Identifier: MIT
#include "cutting_preview.hpp"

#include <algorithm>
#include <vector>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/fabrication/assembly_map.hpp"
#include "planish/fabrication/cut_items.hpp"
#include "planish/fabrication/drawing.hpp"
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

/// The item that `face` is cut from, or the first.
void show_item(const std::vector<CutItem>& items, int face, const std::string& unit,
               CuttingPreview& preview) {
  if (items.empty()) return;
  const auto holds = [&](const CutItem& item) {
    return std::find(item.faces.begin(), item.faces.end(), face) != item.faces.end();
  };
  const auto found = std::find_if(items.begin(), items.end(), holds);
  const CutItem& item = found != items.end() ? *found : items.front();
  preview.shown = item.name;
  preview.drawing = picture_of(item.panel, unit);
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
  if (plan.types) preview.types = static_cast<int>(plan.types->panels.types.size());
  const std::vector<CutItem> items = cut_items(plan, preview);
  if (plan.options.sheet_width > 0.0) place_pieces(plan, items, preview);
  show_item(items, face, plan.options.unit, preview);
  if (with_map) preview.map = write_assembly_map(plan);
  return preview;
}

}  // namespace planish
