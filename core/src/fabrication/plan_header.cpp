// SPDX-License-Identifier: MIT
#include "fabrication/plan_header.hpp"

#include <algorithm>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/mesh/mesh_hash.hpp"

namespace planish {
namespace {

std::string remake_text(const CuttingPlan& plan) {
  if (!plan.remake) return "null";
  return JsonObject()
      .add("outline", plan.remake->count(PanelChange::kOutline))
      .add("bevel", plan.remake->count(PanelChange::kBevel))
      .add("new", plan.remake->count(PanelChange::kNew))
      .add("nodes_moved", plan.remake->count(NodeChange::kMoved))
      .add("nodes_arms", plan.remake->count(NodeChange::kArms))
      .add("nodes_new", plan.remake->count(NodeChange::kNew))
      .text();
}

std::string types_text(const PanelTypes& types) {
  JsonObject text;
  text.add("types", static_cast<double>(types.types.size())).add("within", types.within);
  if (!types.seams.empty()) {
    text.add("joint_min", types.widths.min).add("joint_max", types.widths.max);
  }
  return text.text();
}

std::string apart_text(const PanelNames& names, const DrawnReport& report) {
  std::string text;
  for (const PanelApart& panel : report.apart) {
    text += text.empty() ? "[" : ",";
    text += JsonObject().add("panel", names.of(panel.face)).add("pieces", panel.pieces).text();
  }
  return text + "]";
}

}  // namespace

void measure_flatness(const CuttingPlan& plan, DrawnReport& report) {
  for (int f = 0; f < plan.mesh.face_count(); ++f) {
    const FacePlanarity face = face_planarity(plan.mesh.positions, plan.mesh.face(f));
    report.flatness = std::max(report.flatness, face.mm_per_m);
    report.excess = std::max(report.excess, face.excess);
  }
}

JsonObject plan_header(std::string_view format, const CuttingPlan& plan,
                       const DrawnReport& report) {
  const CuttingOptions& options = plan.options;
  JsonObject header;
  header.add("format", format)
      .raw("version", "1")
      .add("name", options.name)
      .add("unit", options.unit)
      .add("model_unit", options.model_unit)
      .add("scale", plan.scale)
      .add("mesh_hash", hash_text(plan.hash))
      .add("face_up", "outside")
      .add("gap", options.gap)
      .add("thickness", options.thickness)
      .raw("counts", JsonObject()
                         .add("panels", plan.mesh.face_count())
                         .add("edges", static_cast<double>(plan.joints.joints.size()))
                         .add("nodes", static_cast<double>(plan.vertex_of_node.size()))
                         .add("drawn", report.drawn)
                         .text())
      .raw("remake", remake_text(plan))
      .add("flatness_mm_per_m", report.flatness)
      .add("excess_mm_per_m", report.excess)
      .add("vanished", plan.options.names.of(report.vanished));
  if (plan.types) header.raw("types", types_text(plan.types->panels));
  if (!report.apart.empty()) header.raw("apart", apart_text(plan.options.names, report));
  if (!report.lost_sides.empty())
    header.add("lost_sides", plan.options.names.of(report.lost_sides));
  return header;
}

}  // namespace planish
