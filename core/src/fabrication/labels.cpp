// SPDX-License-Identifier: MIT
#include "planish/fabrication/labels.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include "fabrication/neighbours.hpp"
#include "planish/fabrication/drawing.hpp"
#include "planish/mesh/mesh_hash.hpp"
#include "planish/numeric/index.hpp"
#include "planish/text/number.hpp"
#include "planish/text/utf8.hpp"

namespace planish {
namespace {

constexpr std::size_t kManySides = 12;  // more names are set smaller, so that they all find room
constexpr int kQuietZone = 4;           // modules of white around a code, as the standard asks

constexpr std::string_view kStyle =
    "@page{size:A4;margin:0}body{margin:0;font:3.2mm/1.35 sans-serif}"
    ".page{display:grid;grid-template:repeat(4,74mm)/105mm 105mm;height:296mm;overflow:hidden;"
    "break-after:page}.page:last-child{break-after:auto}svg{display:block}"
    ".label{box-sizing:border-box;padding:4mm 6mm;position:relative;overflow:hidden}"
    "b{display:block;font-size:8mm;line-height:1.2}p{margin:1mm 0;width:44mm}"
    ".name{max-height:4.05em;overflow:hidden;overflow-wrap:anywhere}.many{font-size:2mm}"
    "i{font-style:normal;white-space:nowrap}"
    ".code{position:absolute;right:4mm;top:12mm;width:50mm;height:50mm}";

/// The code, drawn once; every label refers to it.
std::string code_symbol(const LinkCode& code) {
  std::string svg = "<svg width=\"0\" height=\"0\"><symbol id=\"code\" viewBox=\"-4 -4 ";
  static_assert(kQuietZone == 4);
  append_decimals(svg, code.size + 2 * kQuietZone);
  svg += ' ';
  append_decimals(svg, code.size + 2 * kQuietZone);
  svg += "\"><path shape-rendering=\"crispEdges\" d=\"";
  const auto is_dark = [&](int x, int y) { return code.dark[at(y * code.size + x)] != 0; };
  for (int y = 0; y < code.size; ++y) {
    for (int x = 0; x < code.size;) {
      int end = x;
      while (end < code.size && is_dark(end, y)) ++end;
      if (end > x) {
        const std::string length = std::to_string(end - x);
        svg.append("M").append(std::to_string(x)).append(" ").append(std::to_string(y));
        svg.append("h").append(length).append("v1h-").append(length).append("z");
      }
      x = end + 1;
    }
  }
  return svg + "\"/></symbol></svg>\n";
}

std::string_view task_of(const CuttingPlan& plan, int face) {
  if (!plan.remake) return "";
  switch (plan.remake->panels[at(face)]) {
    case PanelChange::kUnchanged:
      return "unchanged";
    case PanelChange::kOutline:
      return "cut again";
    case PanelChange::kBevel:
      return "new bevel only";
    case PanelChange::kNew:
      return "new";
  }
  return "";
}

/// Where the triangle of what is cut belongs.
std::string marked_corner(const CuttingPlan& plan, int face) {
  if (!plan.options.by_type) return "On the outside; a triangle marks corner 0.";
  const FamilyMember& member = plan.types->panels.panels[at(face)];
  const auto corners = plan.mesh.face(face);
  const int count = static_cast<int>(corners.size());
  int corner = 0;
  while (member.template_column(corner, count) != 0) ++corner;
  const std::string node = node_name(plan.node_of_vertex[at(corners[at(corner)])]);
  return type_name(member.family) + (member.mirrored ? ", turned over" : "") +
         "; its triangle belongs at " + node + ".";
}

/// Appends a length to five digits, more only before the point: to know the panel by, not to cut
/// it.
void append_rounded(std::string& html, double length) {
  if (length < 1e5) {
    append_number(html, length, 5);
  } else {
    append_decimals(html, std::round(length));
  }
}

void add_label(std::string& html, const CuttingPlan& plan, int face, bool has_code) {
  const BoundingRectangle rectangle = bounding_rectangle(plan.panels[at(face)].outline);
  html += "<div class=\"label\"><b>" + plan.options.names.of(face) + "</b>";
  html += "<p class=\"name\">" + hash_text(plan.hash) + " " + markup_quoted(plan.options.name);
  html += "</p><p>";
  append_rounded(html, rectangle.width);
  html += " × ";
  append_rounded(html, rectangle.height);
  html.append(" ").append(plan.options.unit).append("</p>");
  if (const auto task = task_of(plan, face); !task.empty()) {
    html.append("<p>").append(task).append("</p>");
  }
  const std::vector<std::string> neighbours = neighbour_names(plan, face);
  html += neighbours.size() > kManySides ? "<p class=\"many\">Sides:" : "<p>Sides:";
  for (const std::string& name : neighbours) html += " <i>" + name + "</i>";
  html += "</p><p>" + marked_corner(plan, face) + "</p>";
  if (has_code) html += "<svg class=\"code\"><use href=\"#code\"/></svg>";
  html += "</div>\n";
}

}  // namespace

std::string write_labels(const CuttingPlan& plan, const std::vector<int>& faces,
                         const LinkCode& code) {
  std::string html = "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>";
  html += markup_quoted(plan.options.name) + ": labels</title>\n<style>";
  html.append(kStyle).append("</style>\n");
  if (code.size > 0) html += code_symbol(code);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (k % kLabelsPerPage == 0)
      html += k == 0 ? "<div class=\"page\">\n" : "</div>\n<div class=\"page\">\n";
    add_label(html, plan, faces[k], code.size > 0);
  }
  return html + (faces.empty() ? "" : "</div>\n") + "</html>\n";
}

}  // namespace planish
