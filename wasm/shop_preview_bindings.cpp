// SPDX-License-Identifier: MIT
/// More functions of the module that writes cutting packages: what a package would hold, for the
/// dialog that asks for it, the table of panels, for other formats, and the types of panels. No
/// exception leaves it.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <algorithm>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "cutting_preview.hpp"
#include "planish/fabrication/panel_tables.hpp"
#include "planish/measures/metrics.hpp"
#include "shop_values.hpp"

namespace {

using emscripten::val;
using planish::CuttingOptions;
using planish::CuttingPlan;
using planish::CuttingPreview;
using planish::refused;
using planish::shop::in_memory;
using planish::shop::ShopDesign;
using planish::shop::to_cutting_options;
using planish::shop::to_design;

val to_value(const CuttingPreview& preview, const planish::PanelNames& names) {
  val result = refused("");
  result.set("panels", preview.panels);
  result.set("drawn", preview.drawn);
  result.set("outline", preview.outline);
  result.set("bevel", preview.bevel);
  result.set("nodesMoved", preview.nodes_moved);
  result.set("nodesArms", preview.nodes_arms);
  result.set("flatness", preview.flatness);
  result.set("excess", preview.excess);
  result.set("vanished", val::array(names.of(preview.vanished)));
  result.set("apart", planish::list_of(preview.apart, [&](const planish::PanelApart& panel) {
               val entry = val::object();
               entry.set("panel", names.of(panel.face));
               entry.set("pieces", panel.pieces);
               return entry;
             }));
  result.set("lostSides", val::array(names.of(preview.lost_sides)));
  result.set("oversize", val::array(names.of(preview.oversize)));
  result.set("sheets", preview.sheets);
  result.set("usedFraction", preview.used_fraction);
  result.set("types", preview.types);
  result.set("map", preview.map);
  result.set("shown", preview.shown);
  result.set("drawing", preview.drawing);
  return result;
}

/// Calls `make` with the plan of the design; what it gives is the answer.
template <class Make>
val with_plan(const val& design, const val& given, const Make& make) {
  return in_memory([&] {
    const ShopDesign shown = to_design(design);
    const CuttingOptions options = to_cutting_options(given, shown);
    if (const auto problem = find_problem(options, shown.mesh, true)) return refused(*problem);
    return make(make_cutting_plan(shown.mesh, &shown.base, options));
  });
}

/// `face`: the panel to draw if it is in the scope; `map`: whether the map is wanted.
val cutting_preview(const val& design, const val& options, int face, bool map) {
  return with_plan(design, options, [&](const CuttingPlan& plan) {
    return to_value(planish::preview_cutting(plan, face, map), plan.options.names);
  });
}

val panel_rows(const val& design, const val& options) {
  return with_plan(design, options, [](const CuttingPlan& plan) {
    val result = refused("");
    result.set("csv", planish::panel_table(plan).csv);
    return result;
  });
}

val panel_types(const val& design, double share, bool mirrored) {
  return in_memory([&] {
    const ShopDesign shown = to_design(design);
    CuttingOptions options;
    options.unit = options.model_unit;
    options.types.emplace();
    options.types->within = share * planish::mean_edge_length(shown.mesh);
    options.types->mirrored = mirrored;
    if (const auto problem = find_problem(options, shown.mesh, false)) return refused(*problem);
    const CuttingPlan plan = make_cutting_plan(shown.mesh, nullptr, options);
    const planish::PanelTypes& types = plan.types->panels;
    std::vector<int> of_panel;
    for (const planish::FamilyMember& member : types.panels) of_panel.push_back(member.family);
    std::vector<int> sizes;
    double worst = 0.0;
    for (const planish::PanelType& type : types.types) {
      sizes.push_back(static_cast<int>(type.panels.size()));
      worst = std::max(worst, type.worst);
    }
    val result = refused("");
    result.set("ofPanel", planish::copy(of_panel));
    result.set("sizes", planish::copy(sizes));
    result.set("worstFit", worst);
    result.set("within", types.within);
    return result;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_shop_preview) {
  emscripten::function("cuttingPreview", &cutting_preview);
  emscripten::function("panelTypes", &panel_types);
  emscripten::function("panelRows", &panel_rows);
}
