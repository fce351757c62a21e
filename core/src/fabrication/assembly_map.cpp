// SPDX-License-Identifier: MIT
#include "planish/fabrication/assembly_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "fabrication/view_axes.hpp"
#include "planish/fabrication/drawing.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

constexpr double kMapSize = 1000.0;  ///< of the picture's longer side, in pixels of the SVG

/// The mean normal by area; the z axis where a closed surface has none.
Eigen::Vector3d mean_normal(const CuttingPlan& plan) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double all = 0.0;
  for (const FlatPanel& panel : plan.panels) {
    const double area = area_of(panel.outline);
    sum += area * panel.frame.normal;
    all += std::abs(area);
  }
  if (!(sum.norm() > 1e-3 * all)) return Eigen::Vector3d::UnitZ();
  return sum.normalized();
}

std::string_view fill_of(const CuttingPlan& plan, int face) {
  if (!plan.remake) return "#f4f4f4";
  switch (plan.remake->panels[at(face)]) {
    case PanelChange::kUnchanged:
      return "#f4f4f4";
    case PanelChange::kOutline:
      return "#f6b26b";
    case PanelChange::kBevel:
      return "#9fc5e8";
    case PanelChange::kNew:
      return "#93c47d";
  }
  return "#f4f4f4";
}

/// Panels that show their outside (`front`) or their inside, the farthest first.
std::vector<SeenPanel> seen_panels(const CuttingPlan& plan, const Eigen::Vector3d& towards,
                                   bool front) {
  const ViewAxes view = view_from(front ? towards : Eigen::Vector3d(-towards));
  std::vector<SeenPanel> panels;
  for (int f = 0; f < plan.mesh.face_count(); ++f) {
    const bool faces_us = plan.panels[at(f)].frame.normal.dot(towards) >= 0.0;
    if (faces_us == front) panels.push_back(see_panel(plan.mesh, f, view));
  }
  sort_by_depth(panels);
  return panels;
}

/// Twice the way from `middle` along an axis to the nearest side; infinite if there is none.
double room_along(const Outline& outline, const Eigen::Vector2d& middle, Eigen::Index axis) {
  const Eigen::Index across = 1 - axis;
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < outline.cols(); ++k) {
    const Eigen::Vector2d a = outline.col(k), b = outline.col((k + 1) % outline.cols());
    if ((a(across) > middle(across)) == (b(across) > middle(across))) continue;
    const double t = (middle(across) - a(across)) / (b(across) - a(across));
    nearest = std::min(nearest, std::abs(a(axis) + t * (b(axis) - a(axis)) - middle(axis)));
  }
  return 2.0 * nearest;
}

/// The height of a name in the middle of a panel; a character is 0.65 of its height wide or less.
double name_height(const Outline& outline, const Eigen::Vector2d& middle, std::size_t characters) {
  return std::min({0.22 * std::sqrt(std::abs(area_of(outline))),
                   room_along(outline, middle, 0) / (0.65 * static_cast<double>(characters)),
                   0.7 * room_along(outline, middle, 1)});
}

/// @param at in pixels of the SVG
void add_text(std::string& svg, const Eigen::Vector2d& at, double height, std::string_view text) {
  svg += "<text x=\"";
  append_decimals(svg, at.x());
  svg += "\" y=\"";
  append_decimals(svg, at.y());
  svg += "\" font-size=\"";
  append_decimals(svg, height);
  svg.append("\">").append(text).append("</text>\n");
}

/// Adds the name of a panel; where templates are cut, above that of its type.
void add_names(std::string& svg, const CuttingPlan& plan, int face, const Eigen::Vector2d& middle,
               double height) {
  if (!plan.options.by_type) {
    add_text(svg, middle, height, plan.options.names.of(face));
    return;
  }
  const Eigen::Vector2d down(0.0, 0.45 * height);
  add_text(svg, middle - down, 0.7 * height, plan.options.names.of(face));
  add_text(svg, middle + down, 0.7 * height, type_name(plan.types->panels.panels[at(face)].family));
}

void add_panel(std::string& svg, const CuttingPlan& plan, const SeenPanel& panel,
               const Eigen::Vector2d& origin, double scale) {
  svg.append("<polygon fill=\"").append(fill_of(plan, panel.face)).append("\" points=\"");
  for (const auto p : panel.outline.colwise()) {
    append_decimals(svg, scale * p.x() + origin.x());
    svg += ',';
    append_decimals(svg, origin.y() - scale * p.y());
    svg += ' ';
  }
  svg.back() = '"';
  const Eigen::Vector2d middle = panel.outline.rowwise().mean();
  const std::size_t characters = plan.options.names.of(panel.face).size();
  const double height = scale * name_height(panel.outline, middle, characters);
  svg += "/>";
  const Eigen::Vector2d at(scale * middle.x() + origin.x(), origin.y() - scale * middle.y());
  add_names(svg, plan, panel.face, at, height);
}

/// Adds, where templates are cut, labels that say at which node a corner of its panel belongs.
void add_nodes(std::string& svg, const CuttingPlan& plan, const std::vector<SeenPanel>& panels,
               const Eigen::Vector2d& origin, double scale) {
  if (!plan.options.by_type) return;
  double area = 0.0;
  for (const SeenPanel& panel : panels) area += std::abs(area_of(panel.outline));
  const double height = 0.1 * scale * std::sqrt(area / static_cast<double>(panels.size()));
  std::vector<char> named(at(plan.mesh.vertex_count()), 0);
  for (const SeenPanel& panel : panels) {
    const auto corners = plan.mesh.face(panel.face);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (named[at(corners[k])]++ != 0) continue;
      const Eigen::Vector2d corner = panel.outline.col(static_cast<Eigen::Index>(k));
      const Eigen::Vector2d place(scale * corner.x() + origin.x(), origin.y() - scale * corner.y());
      add_text(svg, place, height, node_name(plan.node_of_vertex[at(corners[k])]));
    }
  }
}

}  // namespace

std::string write_assembly_map(const CuttingPlan& plan) {
  constexpr double kMargin = 40.0;
  const Eigen::Vector3d towards = mean_normal(plan);
  const std::vector<SeenPanel> views[] = {seen_panels(plan, towards, true),
                                          seen_panels(plan, towards, false)};
  const PlanarBox boxes[] = {box_of(views[0]), box_of(views[1])};
  const double extent = std::max((boxes[0].high - boxes[0].low).maxCoeff(),
                                 (boxes[1].high - boxes[1].low).maxCoeff());
  const double scale = extent > 0.0 ? kMapSize / extent : 1.0;
  double right = kMargin;
  double height = 0.0;
  std::string panels;
  for (int side = 0; side < 2; ++side) {
    if (views[side].empty()) continue;
    const PlanarBox& box = boxes[side];
    const Eigen::Vector2d origin(right - scale * box.low.x(), kMargin + scale * box.high.y());
    for (const SeenPanel& panel : views[side]) add_panel(panels, plan, panel, origin, scale);
    add_nodes(panels, plan, views[side], origin, scale);
    right += scale * (box.high.x() - box.low.x()) + kMargin;
    height = std::max(height, scale * (box.high.y() - box.low.y()));
  }
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ";
  append_decimals(svg, right);
  svg += ' ';
  append_decimals(svg, height + 2.0 * kMargin);
  svg += "\">\n<style>polygon{stroke:#444;stroke-width:0.5}";
  svg += "text{font-family:sans-serif;text-anchor:middle;dominant-baseline:central}</style>\n";
  svg +=
      "<text x=\"40\" y=\"20\" font-size=\"14\" style=\"text-anchor:start\">Panels seen from "
      "outside";
  if (!views[1].empty()) svg += "; right: the far side, seen from there";
  if (plan.options.by_type) svg += "; T: its type, N: nodes";
  if (plan.remake) svg += "; orange: cut again, blue: bevel only, green: new";
  return svg + "</text>\n" + panels + "</svg>\n";
}

}  // namespace planish
