// SPDX-License-Identifier: MIT
/// One more function of the module that writes for the workshop: the design at a distance. No
/// exception leaves it.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <string>
#include <variant>

#include "planish/measures/metrics.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/offset/mesh_offset.hpp"
#include "shop_values.hpp"

namespace {

using emscripten::val;
using planish::Mesh;
using planish::MeshOffset;
using planish::OffsetOptions;
using planish::refused;
using planish::Spread;

val to_value(const Spread& spread) {
  val value = val::object();
  value.set("min", spread.min);
  value.set("mean", spread.mean);
  value.set("max", spread.max);
  return value;
}

int spoilt_panels(const Mesh& mesh, const MeshOffset& offset) {
  int count = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto damage = planish::panel_damage(mesh.positions, offset.positions, mesh.face(f));
    if (damage != planish::PanelDamage::kNone) ++count;
  }
  return count;
}

val to_value(const Mesh& mesh, const MeshOffset& offset) {
  val value = refused("");
  value.set("kind", std::string(kind_name(offset.report.kind)));
  value.set("panels", to_value(offset.report.panels));
  value.set("nodes", to_value(offset.report.nodes));
  value.set("deviation", offset.report.deviation);
  value.set("turnedEdges", offset.report.turned_edges);
  value.set("spoilt", spoilt_panels(mesh, offset));
  value.set("excess", planarity_summary(mesh, offset.positions).max_excess);
  value.set("positions", planish::copy(offset.positions));
  return value;
}

/// `kind`: "face", "vertex" or "parallel"; "" for the first of them that the mesh has.
val offset_mesh(const val& design, double distance, const std::string& kind) {
  try {
    const Mesh mesh = planish::shop::to_design(design).mesh;
    const OffsetOptions options{.distance = distance, .kind = planish::offset_kind(kind)};
    if (const auto problem = find_problem(options)) return refused(*problem);
    const auto made = planish::offset_mesh(mesh, options);
    if (const auto* why = std::get_if<std::string>(&made)) return refused(*why);
    return to_value(mesh, std::get<MeshOffset>(made));
  } catch (const std::exception&) {
    return refused("there is not enough memory for this in the browser");
  }
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_offset) { emscripten::function("offsetMesh", &offset_mesh); }
