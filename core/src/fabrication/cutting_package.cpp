// SPDX-License-Identifier: MIT
#include "planish/fabrication/cutting_package.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "fabrication/table_writer.hpp"
#include "planish/constraints/planar_polygon.hpp"
#include "planish/fabrication/assembly_map.hpp"
#include "planish/fabrication/drawing.hpp"
#include "planish/fabrication/panel_drawing.hpp"
#include "planish/fabrication/panel_tables.hpp"
#include "planish/fabrication/sheet_layout.hpp"
#include "planish/index.hpp"
#include "planish/io/number.hpp"
#include "planish/io/zip.hpp"

namespace planish {
namespace {

constexpr double kSpacingMetres = 0.010;  ///< between panels on a sheet

/// A panel that is drawn, and the rectangle that it takes.
struct DrawnPanel {
  int face = 0;
  PanelDrawing panel;
  BoundingRectangle rectangle;
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
  explicit PackageWriter(const CuttingPlan& plan)
      : plan_(plan), spacing_(kSpacingMetres / metres_in(plan.options.unit).value()) {
    measure();
    for (int f = 0; f < plan.mesh.face_count(); ++f) {
      if (plan.drawn[at(f)] == 0) continue;
      auto panel = draw_panel(plan, f);
      if (!panel) {
        report_.vanished.push_back(f);
        continue;
      }
      const BoundingRectangle rectangle = bounding_rectangle(panel->cut);
      panels_.push_back({f, *std::move(panel), rectangle});
    }
    report_.drawn = static_cast<int>(panels_.size());
  }

  CuttingPackage write() {
    const bool has_sheets = plan_.options.sheet_width > 0.0;
    std::vector<SheetPlace> places;
    if (has_sheets) places = place_on_sheets();
    CuttingPackage package;
    package.header = header(has_sheets);
    add_tables(package.header);
    zip_.add("map.svg", write_assembly_map(plan_));
    zip_.add("panels-" + plan_.options.unit + ".dxf", write_dxf(all_panels()));
    for (const DrawnPanel& panel : panels_) {
      zip_.add("panels/" + panel_name(panel.face) + "-" + plan_.options.unit + ".dxf",
               write_dxf(panel.panel.drawing));
    }
    if (has_sheets) add_sheets(places);
    package.zip = zip_.take();
    package.report = std::move(report_);
    return package;
  }

 private:
  void measure() {
    report_.panels = plan_.mesh.face_count();
    report_.edges = static_cast<int>(plan_.joints.joints.size());
    report_.nodes = static_cast<int>(plan_.vertex_of_node.size());
    for (int f = 0; f < report_.panels; ++f) {
      const FacePlanarity face = face_planarity(plan_.mesh.positions, plan_.mesh.face(f));
      report_.flatness = std::max(report_.flatness, face.mm_per_m);
      report_.excess = std::max(report_.excess, face.excess);
    }
  }

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
    for (const DrawnPanel& p : panels_) items.push_back({p.rectangle.width, p.rectangle.height});
    const double width = plan_.options.sheet_width;
    const double height = plan_.options.sheet_height;
    auto places = arrange_on_sheets(items, {width, height, spacing_});
    double area = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      report_.sheets = std::max(report_.sheets, places[k].sheet + 1);
      if (places[k].sheet < 0) {
        report_.oversize.push_back(panels_[k].face);
      } else {
        area += area_of(panels_[k].panel.cut);
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
                onto_axes(panels_[k].rectangle, place.x, place.y, place.turned));
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
  double spacing_;  ///< in the package's unit
  std::vector<DrawnPanel> panels_;
  CuttingReport report_;
  ZipWriter zip_;
};

/// A JSON object, field by field.
class HeaderText {
 public:
  HeaderText& raw(std::string_view field, std::string_view json) {
    text_.append(text_.empty() ? "{" : ",\n").append(json_quoted(field)).append(":").append(json);
    return *this;
  }
  HeaderText& add(std::string_view field, std::string_view text) {
    return raw(field, json_quoted(text));
  }
  HeaderText& add(std::string_view field, double number) {
    std::string digits;
    append_exact(digits, number);
    return raw(field, digits);
  }
  HeaderText& add(std::string_view field, const std::vector<int>& faces) {
    std::string list = "[";
    for (const int face : faces) {
      list.append(list.size() > 1 ? "," : "").append(json_quoted(panel_name(face)));
    }
    return raw(field, list + "]");
  }
  [[nodiscard]] std::string text() const { return text_ + "}"; }

 private:
  std::string text_;
};

std::string hexadecimal(std::uint32_t hash) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (int shift = 28; shift >= 0; shift -= 4)
    text += kDigits[hash >> static_cast<unsigned>(shift) & 15u];
  return text;
}

std::string remake_text(const CuttingPlan& plan) {
  if (!plan.remake) return "null";
  return HeaderText()
      .add("outline", plan.remake->count(PanelChange::kOutline))
      .add("bevel", plan.remake->count(PanelChange::kBevel))
      .add("new", plan.remake->count(PanelChange::kNew))
      .text();
}

std::string PackageWriter::header(bool has_sheets) const {
  const CuttingOptions& options = plan_.options;
  const std::string sheets = has_sheets ? HeaderText()
                                              .add("width", options.sheet_width)
                                              .add("height", options.sheet_height)
                                              .add("spacing", spacing_)
                                              .add("count", report_.sheets)
                                              .add("used_fraction", report_.used_fraction)
                                              .add("method", "rectangles arranged, not nested")
                                              .add("oversize", report_.oversize)
                                              .text()
                                        : "null";
  return HeaderText()
      .add("format", "planish-cutting-package")
      .raw("version", "1")
      .add("name", options.name)
      .add("unit", options.unit)
      .add("model_unit", options.model_unit)
      .add("scale", plan_.scale)
      .add("mesh_hash", hexadecimal(plan_.hash))
      .add("face_up", "outside")
      .add("gap", options.gap)
      .add("thickness", options.thickness)
      .raw("counts", HeaderText()
                         .add("panels", report_.panels)
                         .add("edges", report_.edges)
                         .add("nodes", report_.nodes)
                         .add("drawn", report_.drawn)
                         .text())
      .raw("remake", remake_text(plan_))
      .add("flatness_mm_per_m", report_.flatness)
      .add("vanished", report_.vanished)
      .raw("sheets", sheets)
      .text();
}

}  // namespace

CuttingPackage write_cutting_package(const Mesh& mesh, const Mesh* base,
                                     const CuttingOptions& options) {
  const CuttingPlan plan = make_cutting_plan(mesh, base, options);
  return PackageWriter(plan).write();
}

}  // namespace planish
