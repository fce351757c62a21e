// SPDX-License-Identifier: MIT
#include "planish/fabrication/cutting_package.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fabrication/plan_header.hpp"
#include "planish/fabrication/assembly_map.hpp"
#include "planish/fabrication/drawing.hpp"
#include "planish/fabrication/panel_tables.hpp"
#include "planish/fabrication/type_table.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

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
      : plan_(plan), code_(code), zip_(zip), items_(cut_items(plan, report_)) {
    measure_flatness(plan, report_);
  }

  CuttingPackage write() {
    const bool has_sheets = plan_.options.sheet_width > 0.0;
    std::vector<PlacedPiece> placed;
    if (has_sheets) placed = place_pieces(plan_, items_, report_);
    CuttingPackage package;
    package.header = header(has_sheets);
    add_tables(package.header);
    zip_.add("map.svg", write_assembly_map(plan_));
    zip_.add("labels.html", write_labels(plan_, drawn_faces(), code_));
    const std::string folder = plan_.options.by_type ? "types" : "panels";
    const std::string ending = "-" + plan_.options.unit + ".dxf";
    zip_.add(folder + ending, write_dxf(all_items(), plan_.options.unit));
    for (const CutItem& item : items_) {
      zip_.add(std::string(folder).append("/").append(item.name).append(ending),
               write_dxf(item.panel.drawing, plan_.options.unit));
    }
    if (has_sheets) add_sheets(placed);
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
    json += ",\n\"nodes\":" + nodes.json;
    TableText placements, templates, bar_types, node_types;
    if (plan_.types) {
      placements = type_table(plan_);
      templates = template_table(plan_);
      bar_types = bar_type_table(plan_);
      node_types = node_type_table(plan_);
      json += ",\n\"templates\":" + templates.json + ",\n\"placements\":" + placements.json;
      json += ",\n\"bar_types\":" + bar_types.json + ",\n\"node_types\":" + node_types.json;
    }
    zip_.add("package.json", json + "}\n");
    zip_.add("panels.csv", panels.csv);
    zip_.add("edges.csv", edges.csv);
    zip_.add("nodes.csv", nodes.csv);
    if (!plan_.types) return;
    zip_.add("types.csv", placements.csv);
    zip_.add("templates.csv", templates.csv);
    zip_.add("bar-types.csv", bar_types.csv);
    zip_.add("node-types.csv", node_types.csv);
  }

  std::vector<int> drawn_faces() const {
    std::vector<int> faces;
    for (const CutItem& item : items_) {
      faces.insert(faces.end(), item.faces.begin(), item.faces.end());
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  /// Draws all panels, or one template a type, in rows of about the length of the column of rows,
  /// in their order.
  Drawing all_items() const {
    const double spacing = sheet_spacing(plan_.options);
    double area = 0.0;
    for (const CutItem& p : items_) {
      area += (p.rectangle.width + spacing) * (p.rectangle.height + spacing);
    }
    const double row_length = std::sqrt(area);
    Drawing all;
    double x = 0.0;
    double y = 0.0;
    double row_height = 0.0;
    for (const CutItem& p : items_) {
      if (x > 0.0 && x + p.rectangle.width > row_length) {
        y += row_height + spacing;
        x = row_height = 0.0;
      }
      add_moved(all, p.panel.drawing, onto_axes(p.rectangle, x, y, false));
      x += p.rectangle.width + spacing;
      row_height = std::max(row_height, p.rectangle.height);
    }
    return all;
  }

  void add_sheets(const std::vector<PlacedPiece>& placed) {
    const double width = plan_.options.sheet_width;
    const double height = plan_.options.sheet_height;
    std::vector<Drawing> sheets(at(report_.sheets));
    for (Drawing& sheet : sheets) {
      Outline edge(2, 4);
      edge << 0.0, width, width, 0.0, 0.0, 0.0, height, height;
      sheet.loops.push_back({DrawingLayer::kSheet, edge});
    }
    for (const auto& [index, place] : placed) {
      const CutItem& item = items_[at(index)];
      add_moved(sheets[at(place.sheet)], item.panel.drawing,
                onto_axes(item.room, place.x, place.y, place.turned));
    }
    for (std::size_t k = 0; k < sheets.size(); ++k) {
      std::string number = std::to_string(k + 1);
      if (number.size() < 3) number.insert(0, 3 - number.size(), '0');
      const std::string name = "sheets/sheet-" + number + "-" + plan_.options.unit;
      zip_.add(name + ".dxf", write_dxf(sheets[k], plan_.options.unit));
      zip_.add(name + ".svg", write_svg(sheets[k], width, height, plan_.options.unit));
    }
  }

  std::string header(bool has_sheets) const;

  const CuttingPlan& plan_;
  const LinkCode& code_;
  ZipWriter zip_;
  CuttingReport report_;
  std::vector<CutItem> items_;
};

std::string PackageWriter::header(bool has_sheets) const {
  const CuttingOptions& options = plan_.options;
  const std::string sheets = has_sheets
                                 ? JsonObject()
                                       .add("width", options.sheet_width)
                                       .add("height", options.sheet_height)
                                       .add("spacing", sheet_spacing(options))
                                       .add("count", report_.sheets)
                                       .add("used_fraction", report_.used_fraction)
                                       .add("method", "rectangles arranged, not nested")
                                       .add("oversize", plan_.options.names.of(report_.oversize))
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
