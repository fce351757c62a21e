// SPDX-License-Identifier: MIT
#include "planish/fabrication/cut_items.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// The drawn panels of each item, before anything is drawn.
std::vector<std::vector<int>> faces_of_items(const CuttingPlan& plan) {
  std::vector<std::vector<int>> faces;
  if (plan.options.by_type) faces.resize(plan.types->panels.types.size());
  for (int f = 0; f < plan.mesh.face_count(); ++f) {
    if (plan.drawn[at(f)] == 0) continue;
    if (plan.options.by_type) {
      faces[at(plan.types->panels.panels[at(f)].family)].push_back(f);
    } else {
      faces.push_back({f});
    }
  }
  return faces;
}

}  // namespace

std::vector<CutItem> cut_items(const CuttingPlan& plan, CuttingReport& report) {
  std::vector<CutItem> items;
  const bool by_type = plan.options.by_type;
  const std::vector<std::vector<int>> faces = faces_of_items(plan);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (faces[k].empty()) continue;
    const int type = static_cast<int>(k), face = faces[k].front();
    auto panel = by_type ? draw_template(plan, type, faces[k]) : draw_panel(plan, face);
    if (!panel) {
      report.vanished.insert(report.vanished.end(), faces[k].begin(), faces[k].end());
      continue;
    }
    for (const int f : faces[k]) note_pieces(plan, f, panel->pieces, report);
    report.drawn += static_cast<int>(faces[k].size());
    const BoundingRectangle rectangle = bounding_rectangle(corners_of(panel->pieces));
    const BoundingRectangle room = room_on_sheet(*panel, sheet_spacing(plan.options));
    items.push_back({by_type ? type_name(type) : plan.options.names.of(face), faces[k],
                     *std::move(panel), rectangle, room});
  }
  return items;
}

std::vector<PlacedPiece> place_pieces(const CuttingPlan& plan, const std::vector<CutItem>& items,
                                      CuttingReport& report) {
  const CuttingOptions& options = plan.options;
  std::vector<SheetItem> pieces;
  std::vector<std::pair<int, int>> item_and_face;
  for (std::size_t k = 0; k < items.size(); ++k) {
    for (const int face : items[k].faces) {
      pieces.push_back({items[k].room.width, items[k].room.height});
      item_and_face.emplace_back(static_cast<int>(k), face);
    }
  }
  const SheetSize sheet{options.sheet_width, options.sheet_height, sheet_spacing(options)};
  const std::vector<SheetPlace> places = arrange_on_sheets(pieces, sheet);
  std::vector<PlacedPiece> placed;
  double area = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto [item, face] = item_and_face[k];
    if (places[k].sheet < 0) {
      report.oversize.push_back(face);
      continue;
    }
    report.sheets = std::max(report.sheets, places[k].sheet + 1);
    area += area_of(items[at(item)].panel.pieces);
    placed.push_back({item, places[k]});
  }
  if (report.sheets > 0) {
    report.used_fraction = area / (report.sheets * sheet.width * sheet.height);
  }
  return placed;
}

double sheet_spacing(const CuttingOptions& options) {
  return kSheetSpacing / metres_in(options.unit).value();
}

}  // namespace planish
