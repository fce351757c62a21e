// SPDX-License-Identifier: MIT
#include "planish/fabrication/cutting_package.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "fabrication/plan_header.hpp"
#include "planish/fabrication/assembly_map.hpp"
#include "planish/fabrication/drawing.hpp"
#include "planish/fabrication/panel_drawing.hpp"
#include "planish/fabrication/panel_tables.hpp"
#include "planish/fabrication/sheet_layout.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// A panel that is drawn, the rectangle around what is cut, and what it takes on a sheet.
struct DrawnPanel {
  int face = 0;
  PanelDrawing panel;
  BoundingRectangle rectangle, room;
};

/// Moves a rectangle so that it lies along the axes with its lower left corner at (x, y).
PlanarMotion onto_axes(const BoundingRectangle& r, double x, double y, bool turned) {
  const Eigen::Vector2d back(r.along.x(), -r.along.y());
  PlanarMotion motion;
  motion.x_axis = turned ? Eigen::Vector2d(-back.y(), back.x()) : back;
  const Eigen::Vector2d corner = motion.apply(r.corner);
  motion.shift = Eigen::Vector2d(turned ? x + r.height : x, y) - corner;
  return motion;
}

class PackageWriter {
 public:
  PackageWriter(const CuttingPlan& plan, const LinkCode& code, const ByteSink& zip)
      : plan_(plan),
        code_(code),
        spacing_(kSheetSpacing / metres_in(plan.options.unit).value()),
        zip_(zip) {
    for (int f = 0; f < plan.mesh.face_count(); ++f) {
      if (plan.drawn[at(f)] == 0) continue;
      auto panel = draw_panel(plan, f);
      if (!panel) {
        report_.vanished.push_back(f);
        continue;
      }
      note_pieces(plan, f, panel->pieces, report_);
      const BoundingRectangle rectangle = bounding_rectangle(corners_of(panel->pieces));
      const BoundingRectangle room = room_on_sheet(*panel, spacing_);
      panels_.push_back({f, *std::move(panel), rectangle, room});
    }
    report_.drawn = static_cast<int>(panels_.size());
    measure_flatness(plan, report_);
  }

  CuttingPackage write() {
    const bool has_sheets = plan_.options.sheet_width > 0.0;
    std::vector<SheetPlace> places;
    if (has_sheets) places = place_on_sheets();
    CuttingPackage package;
    package.header = header(has_sheets);
    add_tables(package.header);
    zip_.add("map.svg", write_assembly_map(plan_));
    zip_.add("labels.html", write_labels(plan_, drawn_faces(), code_));
    zip_.add("panels-" + plan_.options.unit + ".dxf", write_dxf(all_panels()));
    for (const DrawnPanel& panel : panels_) {
      zip_.add("panels/" + panel_name(panel.face) + "-" + plan_.options.unit + ".dxf",
               write_dxf(panel.panel.drawing));
    }
    if (has_sheets) add_sheets(places);
    zip_.finish();
    package.report = std::move(report_);
    return package;
  }

 private:
  void add_tables(const std::string& header) {
    const TableText panels = panel_table(plan_);
    const TableText edges = edge_table(plan_);
    const TableText nodes = node_table(plan_);
    std::string json = header;
    json.erase(json.find_last_of('}'));
    json += ",\n\"panels\":" + panels.json + ",\n\"edges\":" + edges.json;
    json += ",\n\"nodes\":" + nodes.json + "}\n";
    zip_.add("package.json", json);
    zip_.add("panels.csv", panels.csv);
    zip_.add("edges.csv", edges.csv);
    zip_.add("nodes.csv", nodes.csv);
  }

  std::vector<int> drawn_faces() const {
    std::vector<int> faces;
    for (const DrawnPanel& panel : panels_) faces.push_back(panel.face);
    return faces;
  }

  /// All panels in rows of about the length of the column of rows, in their order.
  Drawing all_panels() const {
    double area = 0.0;
    for (const DrawnPanel& p : panels_) {
      area += (p.rectangle.width + spacing_) * (p.rectangle.height + spacing_);
    }
    const double row_length = std::sqrt(area);
    Drawing all;
    double x = 0.0;
    double y = 0.0;
    double row_height = 0.0;
    for (const DrawnPanel& p : panels_) {
      if (x > 0.0 && x + p.rectangle.width > row_length) {
        y += row_height + spacing_;
        x = row_height = 0.0;
      }
      add_moved(all, p.panel.drawing, onto_axes(p.rectangle, x, y, false));
      x += p.rectangle.width + spacing_;
      row_height = std::max(row_height, p.rectangle.height);
    }
    return all;
  }

  std::vector<SheetPlace> place_on_sheets() {
    std::vector<SheetItem> items;
    items.reserve(panels_.size());
    for (const DrawnPanel& p : panels_) items.push_back({p.room.width, p.room.height});
    const double width = plan_.options.sheet_width;
    const double height = plan_.options.sheet_height;
    auto places = arrange_on_sheets(items, {width, height, spacing_});
    double area = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      report_.sheets = std::max(report_.sheets, places[k].sheet + 1);
      if (places[k].sheet < 0) {
        report_.oversize.push_back(panels_[k].face);
      } else {
        area += area_of(panels_[k].panel.pieces);
      }
    }
    if (report_.sheets > 0) report_.used_fraction = area / (report_.sheets * width * height);
    return places;
  }

  void add_sheets(const std::vector<SheetPlace>& places) {
    const double width = plan_.options.sheet_width;
    const double height = plan_.options.sheet_height;
    std::vector<Drawing> sheets(at(report_.sheets));
    for (Drawing& sheet : sheets) {
      Outline edge(2, 4);
      edge << 0.0, width, width, 0.0, 0.0, 0.0, height, height;
      sheet.loops.push_back({DrawingLayer::kSheet, edge});
    }
    for (std::size_t k = 0; k < places.size(); ++k) {
      const SheetPlace& place = places[k];
      if (place.sheet < 0) continue;
      add_moved(sheets[at(place.sheet)], panels_[k].panel.drawing,
                onto_axes(panels_[k].room, place.x, place.y, place.turned));
    }
    for (std::size_t k = 0; k < sheets.size(); ++k) {
      std::string number = std::to_string(k + 1);
      if (number.size() < 3) number.insert(0, 3 - number.size(), '0');
      const std::string name = "sheets/sheet-" + number + "-" + plan_.options.unit;
      zip_.add(name + ".dxf", write_dxf(sheets[k]));
      zip_.add(name + ".svg", write_svg(sheets[k], width, height, plan_.options.unit));
    }
  }

  std::string header(bool has_sheets) const;

  const CuttingPlan& plan_;
  const LinkCode& code_;
  double spacing_;  ///< in the package's unit
  std::vector<DrawnPanel> panels_;
  CuttingReport report_;
  ZipWriter zip_;
};

std::string PackageWriter::header(bool has_sheets) const {
  const CuttingOptions& options = plan_.options;
  const std::string sheets = has_sheets ? JsonObject()
                                              .add("width", options.sheet_width)
                                              .add("height", options.sheet_height)
                                              .add("spacing", spacing_)
                                              .add("count", report_.sheets)
                                              .add("used_fraction", report_.used_fraction)
                                              .add("method", "rectangles arranged, not nested")
                                              .add("oversize", panel_names(report_.oversize))
                                              .text()
                                        : "null";
  const std::string labels = JsonObject()
                                 .add("count", report_.drawn)
                                 .raw("link", code_.link.empty() ? "null" : json_quoted(code_.link))
                                 .raw("code", code_.size > 0 ? "true" : "false")
                                 .text();
  return plan_header("planish-cutting-package", plan_, report_)
      .add("text_height", options.text_height)
      .raw("sheets", sheets)
      .raw("labels", labels)
      .text();
}

}  // namespace

CuttingPackage write_cutting_package(const Mesh& mesh, const Mesh* base,
                                     const CuttingOptions& options, const ByteSink& zip,
                                     const LinkCode& code) {
  const CuttingPlan plan = make_cutting_plan(mesh, base, options);
  return PackageWriter(plan, code, zip).write();
}

}  // namespace planish
