// SPDX-License-Identifier: MIT
#include "planish/fabrication/structure_drawings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fabrication/drawing_notes.hpp"
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

/// A drawing in the structure's own coordinates, with where it is seen from.
struct NamedDrawing {
  std::string name;
  std::string place;  ///< of a section, in words
  ViewAxes view;
  Drawing drawing;
  PlanarBox box;  ///< of the drawing
};

NamedDrawing draw_view(const Mesh& mesh, const NamedView& view) {
  const ViewAxes axes = view_from(view.towards);
  std::vector<SeenPanel> panels;
  panels.reserve(at(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) panels.push_back(see_panel(mesh, f, axes));
  sort_by_depth(panels);
  NamedDrawing result{view.name, "", axes, {}, {}};
  for (SeenPanel& panel : panels) {
    const bool shows_outside =
        panel_normal(mesh.positions, mesh.face(panel.face)).dot(view.towards) >= 0.0;
    result.drawing.loops.push_back(
        {shows_outside ? DrawingLayer::kOutside : DrawingLayer::kInside, std::move(panel.outline)});
  }
  result.box = box_of(result.drawing);
  return result;
}

/// The unit of levels and of places of sections: feet of a model in inches or feet, else metres.
std::string level_unit(const DrawingOptions& options) {
  return options.model_unit == "in" || options.model_unit == "ft" ? "ft" : "m";
}

/// " at x = 4.5 m" where one coordinate says it.
/// @param levels `unit`s in one of the plane's unit
std::string place_of(const SectionPlane& plane, double levels, const std::string& unit) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(plane.normal[k]) != 1.0) continue;
    std::string place = std::string(" at ") + "xyz"[k] + " = ";
    append_decimals(place, plane.normal[k] * plane.offset * levels);
    place += ' ';
    place += unit;
    return place;
  }
  return "";
}

NamedDrawing draw_section(const std::vector<SectionLine>& lines, const SectionPlane& plane,
                          std::string name, std::string place) {
  const ViewAxes axes = view_from(plane.normal);
  NamedDrawing result{std::move(name), std::move(place), axes, {}, {}};
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

/// "roof, plan, 1:50, sizes in mm, levels in m, mesh 1a2b3c4d".
std::string title_of(const DrawingOptions& options, const NamedDrawing& drawing, double scale,
                     const std::string& hash) {
  std::string title = options.name + ", " + drawing.name + drawing.place + ", 1:";
  append_decimals(title, scale);
  const std::string unit = options.unit == "in"   ? "inches"
                           : options.unit == "ft" ? "feet"
                                                  : options.unit;
  return title + ", sizes in " + unit + ", levels in " + level_unit(options) + ", mesh " + hash;
}

/// What one set of drawings has in common, in the unit of its DXF.
struct DrawingSet {
  const DrawingOptions& options;
  DrawingNotes notes;        ///< without their title
  double millimetres = 1.0;  ///< in one of the unit
  std::string hash;          ///< of the mesh

  /// What stands round the drawing at 1 : `scale`.
  [[nodiscard]] Drawing notes_of(const NamedDrawing& d, double scale) const {
    DrawingNotes titled = notes;
    titled.title = title_of(options, d, scale, hash);
    return notes_round(d.box, d.view, titled, scale / millimetres);
  }

  [[nodiscard]] bool fits(const NamedDrawing& d, double scale) const {
    const PlanarBox& bare = d.box;
    const PlanarBox round = box_of(notes_of(d, scale));
    const Eigen::Vector2d size =
        millimetres / scale * (round.high.cwiseMax(bare.high) - round.low.cwiseMin(bare.low));
    return size.x() <= kPaperWidth - 2.0 * kMargin && size.y() <= kPaperHeight - 2.0 * kMargin;
  }

  /// The first of 1, 2, 5, 10, 20, 25 and 50 times a power of ten at which all drawings fit A3.
  [[nodiscard]] double usual_scale(const std::vector<NamedDrawing>& drawings) const {
    constexpr std::array<double, 4> kSteps = {1.0, 2.0, 2.5, 5.0};
    for (double power = 1.0; power < 1e12; power *= 10.0) {
      for (const double step : kSteps) {
        if (step * power == 2.5) continue;  // 1 : 2.5 is not usual, 1 : 25 is
        const double scale = step * power;
        const auto fit = [&](const NamedDrawing& d) { return fits(d, scale); };
        if (std::all_of(drawings.begin(), drawings.end(), fit)) return scale;
      }
    }
    return 1e12;
  }
};

/// A drawing on paper: mm, everything inside the margin.
std::string paper_svg(const Drawing& drawing, double factor) {
  const PlanarBox box = box_of(drawing);
  const Eigen::Vector2d margin(kMargin, kMargin);
  const auto on_paper = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return factor * (p - box.low) + margin;
  };
  Drawing paper = drawing;
  for (DrawnLoop& loop : paper.loops) {
    for (auto point : loop.points.colwise()) point = on_paper(point);
  }
  for (DrawnText& text : paper.texts) {
    text.position = on_paper(text.position);
    text.height *= factor;
  }
  const Eigen::Vector2d size = factor * (box.high - box.low) + 2.0 * margin;
  return write_svg(paper, size.x(), size.y(), "mm");
}

std::string exact_text(double number) {
  std::string text;
  append_exact(text, number);
  return text;
}

std::string json_of(const std::vector<double>& numbers) {
  std::string json;
  for (const double number : numbers) {
    json += json.empty() ? '[' : ',';
    append_exact(json, number);
  }
  return json + ']';
}

std::string json_of(const std::vector<DrawingAxis>& axes) {
  std::string json;
  for (const DrawingAxis& axis : axes) {
    json += json.empty() ? "[" : ",";
    json += JsonObject()
                .add("axis", std::string(1, "xyz"[axis.coordinate]))
                .add("at", axis.at)
                .add("name", axis.name)
                .text();
  }
  return json.empty() ? "[]" : json + "]";
}

/// The axes that are stated, and the levels of the lowest and the highest point.
std::vector<DrawingAxis> drawn_axes(const Mesh& mesh, const DrawingOptions& options,
                                    double factor) {
  std::vector<DrawingAxis> axes = options.axes;
  for (DrawingAxis& axis : axes) axis.at *= factor;
  if (mesh.positions.cols() == 0) return axes;
  const double low = mesh.positions.row(2).minCoeff(), high = mesh.positions.row(2).maxCoeff();
  const double least = 1e-9 * std::max({1.0, std::abs(low), std::abs(high)});
  for (const double level : {low, high}) {
    const auto there = [&](const DrawingAxis& axis) {
      return axis.coordinate == 2 && std::abs(axis.at - level) <= least;
    };
    if (std::none_of(axes.begin(), axes.end(), there)) axes.push_back({2, level, ""});
  }
  return axes;
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
  for (const DrawingAxis& axis : options.axes) {
    if (!std::isfinite(axis.at) || axis.coordinate < 0 || axis.coordinate > 2) {
      return "axis must be x, y or z at a finite place";
    }
  }
  return std::nullopt;
}

Refusal find_problem(const DrawingOptions& options, const Mesh& mesh) {
  constexpr double kFarthest = 10.0;  // sizes of the structure: its drawing would be a dot
  if (const Refusal problem = find_problem(options)) return problem;
  if (mesh.positions.cols() == 0) return std::nullopt;
  const Eigen::Vector3d low = mesh.positions.rowwise().minCoeff();
  const Eigen::Vector3d high = mesh.positions.rowwise().maxCoeff();
  const double size = (high - low).maxCoeff();
  for (const DrawingAxis& axis : options.axes) {
    const double nearest = std::clamp(axis.at, low[axis.coordinate], high[axis.coordinate]);
    const double off = std::abs(axis.at - nearest);
    if (off <= kFarthest * size) continue;
    std::string problem = std::string("axis ") + "xyz"[axis.coordinate] + "=";
    append_decimals(problem, axis.at);
    return problem + " is " + three_digits(off / size) +
           " times the structure's size away from it: places are in the unit of the model, " +
           options.model_unit;
  }
  return std::nullopt;
}

StructureDrawings write_drawings(const Mesh& given, const DrawingOptions& options) {
  const double metres = metres_in(options.unit).value();
  const double factor = metres_in(options.model_unit).value() / metres;
  const std::string level = level_unit(options);
  const double levels = metres / metres_in(level).value();
  Mesh mesh = given;
  mesh.positions *= factor;
  std::vector<NamedDrawing> drawings;
  for (const NamedView& view : all_views()) drawings.push_back(draw_view(mesh, view));
  DrawingSet set{options,
                 {drawn_axes(mesh, options, factor), {}, options.unit, levels, ""},
                 1000.0 * metres,
                 hash_text(mesh_hash(given))};
  const JointTable joints = joint_table(mesh);
  StructureDrawings result;
  ZipWriter zip([&](std::string_view piece) { result.zip += piece; });
  for (std::size_t k = 0; k < options.sections.size(); ++k) {
    SectionPlane plane = options.sections[k];
    plane.offset *= factor;
    const std::vector<SectionLine> lines = cut_by(mesh, joints, plane);
    const std::string number = std::to_string(k + 1), name = "section-" + number;
    if (lines.empty()) {
      result.missed.push_back(static_cast<int>(k));
    } else {
      set.notes.sections.push_back({plane, number});
    }
    zip.add(name + "-" + options.unit + ".csv", section_table(options.names, lines));
    drawings.push_back(draw_section(lines, plane, name, place_of(plane, levels, level)));
  }
  const bool own = options.own_scales && options.scale == 0.0;
  const double common = own ? 0.0 : options.scale > 0.0 ? options.scale : set.usual_scale(drawings);
  std::vector<std::string> names;
  std::vector<double> scales;
  for (const NamedDrawing& d : drawings) {
    names.push_back(d.name);
    const double scale = own ? set.usual_scale({d}) : common;
    scales.push_back(scale);
    Drawing drawing = d.drawing;
    add_moved(drawing, set.notes_of(d, scale), {});
    zip.add(d.name + ".svg", paper_svg(drawing, set.millimetres / scale));
    zip.add(d.name + "-" + options.unit + ".dxf", write_dxf(drawing, options.unit));
  }
  result.header = JsonObject()
                      .add("format", "planish-drawings")
                      .raw("version", "1")
                      .add("name", options.name)
                      .add("unit", options.unit)
                      .add("model_unit", options.model_unit)
                      .add("mesh_hash", set.hash)
                      .raw("scale", own ? "null" : exact_text(common))
                      .raw("scales", json_of(scales))
                      .raw("axes", json_of(set.notes.axes))
                      .add("drawings", names)
                      .add("missed", result.missed)
                      .text();
  zip.add("drawings.json", result.header + "\n");
  zip.finish();
  return result;
}

}  // namespace planish
