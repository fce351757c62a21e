// SPDX-License-Identifier: MIT
#include "planish/fabrication/assembly_map.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "fabrication/view_axes.hpp"
#include "planish/fabrication/drawing.hpp"
#include "planish/index.hpp"

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

/// Those that show their outside (`front`) or their inside, the farthest first.
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
  const double height = 0.22 * scale * std::sqrt(std::abs(area_of(panel.outline)));
  svg += "/><text x=\"";
  append_decimals(svg, scale * middle.x() + origin.x());
  svg += "\" y=\"";
  append_decimals(svg, origin.y() - scale * middle.y());
  svg += "\" font-size=\"";
  append_decimals(svg, height);
  svg.append("\">").append(panel_name(panel.face)).append("</text>\n");
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
  if (plan.remake) svg += "; orange: cut again, blue: bevel only, green: new";
  return svg + "</text>\n" + panels + "</svg>\n";
}

}  // namespace planish
