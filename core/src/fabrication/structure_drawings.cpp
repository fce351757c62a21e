// SPDX-License-Identifier: MIT
#include "planish/fabrication/structure_drawings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fabrication/json_object.hpp"
#include "fabrication/view_axes.hpp"
#include "planish/fabrication/cutting_plan.hpp"
#include "planish/fabrication/drawing.hpp"
#include "planish/fabrication/panel_frame.hpp"
#include "planish/io/zip.hpp"
#include "planish/mesh/mesh_hash.hpp"
#include "planish/numeric/index.hpp"
#include "planish/text/number.hpp"

namespace planish {
namespace {

constexpr double kMargin = 10.0;       // around an SVG, mm of paper
constexpr double kTitleHeight = 3.5;   // mm of paper
constexpr double kPaperWidth = 420.0;  // A3
constexpr double kPaperHeight = 297.0;

struct NamedView {
  const char* name;
  Eigen::Vector3d towards;
};

/// Elevations are named by the side that they show: the front is at the lowest y.
std::array<NamedView, 5> all_views() {
  return {{{"plan", Eigen::Vector3d::UnitZ()},
           {"elevation-front", -Eigen::Vector3d::UnitY()},
           {"elevation-right", Eigen::Vector3d::UnitX()},
           {"elevation-back", Eigen::Vector3d::UnitY()},
           {"elevation-left", -Eigen::Vector3d::UnitX()}}};
}

/// A drawing in the structure's own coordinates, with what it is seen in.
struct NamedDrawing {
  std::string name;
  Drawing drawing;
  PlanarBox box;
};

PlanarBox box_of(const Drawing& drawing) {
  if (drawing.loops.empty()) return {};
  const Outline& first = drawing.loops[0].points;
  PlanarBox box{first.rowwise().minCoeff(), first.rowwise().maxCoeff()};
  for (const DrawnLoop& loop : drawing.loops) {
    box.low = box.low.cwiseMin(loop.points.rowwise().minCoeff());
    box.high = box.high.cwiseMax(loop.points.rowwise().maxCoeff());
  }
  return box;
}

NamedDrawing draw_view(const Mesh& mesh, const NamedView& view) {
  const ViewAxes axes = view_from(view.towards);
  std::vector<SeenPanel> panels;
  panels.reserve(at(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) panels.push_back(see_panel(mesh, f, axes));
  sort_by_depth(panels);
  NamedDrawing result{view.name, {}, {}};
  for (SeenPanel& panel : panels) {
    const bool shows_outside =
        panel_normal(mesh.positions, mesh.face(panel.face)).dot(view.towards) >= 0.0;
    result.drawing.loops.push_back(
        {shows_outside ? DrawingLayer::kOutside : DrawingLayer::kInside, std::move(panel.outline)});
  }
  result.box = box_of(result.drawing);
  return result;
}

NamedDrawing draw_section(const std::vector<SectionLine>& lines, const SectionPlane& plane,
                          std::string name) {
  const ViewAxes axes = view_from(plane.normal);
  NamedDrawing result{std::move(name), {}, {}};
  for (const SectionLine& line : lines) {
    DrawnLoop loop{DrawingLayer::kSection, Outline(2, line.points.cols()), line.closed};
    for (Eigen::Index k = 0; k < line.points.cols(); ++k) {
      loop.points.col(k) = axes.seen(line.points.col(k));
    }
    result.drawing.loops.push_back(std::move(loop));
  }
  result.box = box_of(result.drawing);
  return result;
}

/// The points of a section in the model's axes, with every digit.
std::string section_table(const PanelNames& names, const std::vector<SectionLine>& lines) {
  std::string csv = "line,closed,x,y,z,panel\r\n";
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const SectionLine& line = lines[k];
    for (Eigen::Index p = 0; p < line.points.cols(); ++p) {
      csv += std::to_string(k + 1) + (line.closed ? ",yes" : ",no");
      for (const double x : line.points.col(p)) {
        csv += ',';
        append_exact(csv, x);
      }
      const auto stretch = static_cast<std::size_t>(p);
      csv += ',' + (stretch < line.panels.size() ? names.of(line.panels[stretch]) : "-") + "\r\n";
    }
  }
  return csv;
}

/// The first of 1, 2, 5, 10, 20, 25 and 50 times a power of ten at which all drawings fit A3.
double usual_scale(const std::vector<NamedDrawing>& drawings, double millimetres) {
  double needed = 0.0;
  for (const NamedDrawing& d : drawings) {
    const Eigen::Vector2d size = millimetres * (d.box.high - d.box.low);
    needed = std::max({needed, size.x() / (kPaperWidth - 2.0 * kMargin),
                       size.y() / (kPaperHeight - 3.0 * kMargin)});
  }
  constexpr std::array<double, 4> kSteps = {1.0, 2.0, 2.5, 5.0};
  for (double power = 1.0; power < 1e12; power *= 10.0) {
    for (const double step : kSteps) {
      if (step * power == 2.5) continue;  // 1 : 2.5 is not usual, 1 : 25 is
      if (step * power >= needed) return step * power;
    }
  }
  return std::max(needed, 1.0);
}

/// On paper: mm, the lower left corner of the drawing inside the margin, a title below it.
std::string paper_svg(const NamedDrawing& d, double scale, double millimetres) {
  const double factor = millimetres / scale;
  const double below = 2.0 * kMargin;
  Drawing paper;
  for (DrawnLoop loop : d.drawing.loops) {
    loop.points = factor * (loop.points.colwise() - d.box.low);
    loop.points.colwise() += Eigen::Vector2d(kMargin, below);
    paper.loops.push_back(std::move(loop));
  }
  std::string title = d.name + " 1:";
  append_decimals(title, scale);
  const Eigen::Vector2d size = factor * (d.box.high - d.box.low);
  const double width = std::max(size.x(), 40.0) + 2.0 * kMargin;
  paper.texts.push_back({{0.5 * width, kMargin}, kTitleHeight, 0.0, title});
  return write_svg(paper, width, size.y() + below + kMargin, "mm");
}

}  // namespace

Refusal find_problem(const DrawingOptions& options) {
  if (!metres_in(options.model_unit)) return "model_unit must be mm, cm, m, km, in or ft";
  if (!metres_in(options.unit)) return "unit must be mm, cm, m, km, in or ft";
  if (!std::isfinite(options.scale) || options.scale < 0.0) return "scale must be at least 0";
  for (const SectionPlane& plane : options.sections) {
    if (!std::isfinite(plane.offset) || !(std::abs(plane.normal.norm() - 1.0) < 1e-9)) {
      return "section must be a plane with a direction";
    }
  }
  return std::nullopt;
}

StructureDrawings write_drawings(const Mesh& given, const DrawingOptions& options) {
  const double metres = metres_in(options.unit).value();
  const double factor = metres_in(options.model_unit).value() / metres;
  Mesh mesh = given;
  mesh.positions *= factor;
  std::vector<NamedDrawing> drawings;
  for (const NamedView& view : all_views()) drawings.push_back(draw_view(mesh, view));
  const JointTable joints = joint_table(mesh);
  StructureDrawings result;
  ZipWriter zip([&](std::string_view piece) { result.zip += piece; });
  for (std::size_t k = 0; k < options.sections.size(); ++k) {
    SectionPlane plane = options.sections[k];
    plane.offset *= factor;
    const std::vector<SectionLine> lines = cut_by(mesh, joints, plane);
    if (lines.empty()) result.missed.push_back(static_cast<int>(k));
    const std::string name = "section-" + std::to_string(k + 1);
    zip.add(name + "-" + options.unit + ".csv", section_table(options.names, lines));
    drawings.push_back(draw_section(lines, plane, name));
  }
  const double millimetres = 1000.0 * metres;
  const double scale = options.scale > 0.0 ? options.scale : usual_scale(drawings, millimetres);
  std::vector<std::string> names;
  for (const NamedDrawing& d : drawings) {
    names.push_back(d.name);
    zip.add(d.name + ".svg", paper_svg(d, scale, millimetres));
    zip.add(d.name + "-" + options.unit + ".dxf", write_dxf(d.drawing));
  }
  result.header = JsonObject()
                      .add("format", "planish-drawings")
                      .raw("version", "1")
                      .add("name", options.name)
                      .add("unit", options.unit)
                      .add("model_unit", options.model_unit)
                      .add("mesh_hash", hash_text(mesh_hash(given)))
                      .add("scale", scale)
                      .add("drawings", names)
                      .add("missed", result.missed)
                      .text();
  zip.add("drawings.json", result.header + "\n");
  zip.finish();
  return result;
}

}  // namespace planish
