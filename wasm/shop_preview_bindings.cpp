// SPDX-License-Identifier: MIT
/// Two more functions of the module that writes cutting packages: what a package would hold, for
/// the dialog that asks for it, and the table of panels, for other formats. No exception leaves it.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <string>

#include "cutting_preview.hpp"
#include "planish/fabrication/panel_tables.hpp"

namespace {

using emscripten::val;
using planish::CuttingOptions;
using planish::CuttingPlan;
using planish::CuttingPreview;
using planish::Mesh;
using planish::Positions;

Positions to_positions(const val& numbers) {
  const auto flat = emscripten::convertJSArrayToNumberVector<double>(numbers);
  return Eigen::Map<const Positions>(flat.data(), 3, static_cast<Eigen::Index>(flat.size() / 3));
}

CuttingOptions to_options(const val& options) {
  CuttingOptions result;
  result.name = options["name"].as<std::string>();
  result.model_unit = options["modelUnit"].as<std::string>();
  result.unit = options["unit"].as<std::string>();
  result.gap = options["gap"].as<double>();
  result.thickness = options["thickness"].as<double>();
  result.sheet_width = options["sheetWidth"].as<double>();
  result.sheet_height = options["sheetHeight"].as<double>();
  result.remake_only = options["remakeOnly"].as<bool>();
  return result;
}

val answer(const std::string& problem) {
  val result = val::object();
  result.set("problem", problem);
  return result;
}

val panel_names(const std::vector<int>& faces) {
  val names = val::array();
  for (const int face : faces) names.call<void>("push", planish::panel_name(face));
  return names;
}

val to_value(const CuttingPreview& preview) {
  val result = answer("");
  result.set("panels", preview.panels);
  result.set("drawn", preview.drawn);
  result.set("outline", preview.outline);
  result.set("bevel", preview.bevel);
  result.set("flatness", preview.flatness);
  result.set("vanished", panel_names(preview.vanished));
  result.set("oversize", panel_names(preview.oversize));
  result.set("sheets", preview.sheets);
  result.set("usedFraction", preview.used_fraction);
  result.set("map", preview.map);
  result.set("shown", preview.shown < 0 ? std::string() : planish::panel_name(preview.shown));
  result.set("drawing", preview.drawing);
  return result;
}

/// Calls `make` with the plan of the mesh against `base`; what it gives is the answer.
template <class Make>
val with_plan(const val& base, const val& offsets, const val& vertices, const val& moved,
              const val& moved_positions, const val& given, const Make& make) {
  try {
    Mesh before;
    before.positions = to_positions(base);
    before.face_offsets = emscripten::convertJSArrayToNumberVector<int>(offsets);
    before.face_vertices = emscripten::convertJSArrayToNumberVector<int>(vertices);
    Mesh mesh = before;
    const auto indices = emscripten::convertJSArrayToNumberVector<int>(moved);
    mesh.positions(Eigen::all, indices) = to_positions(moved_positions);
    const CuttingOptions options = to_options(given);
    if (const auto problem = find_problem(options, mesh, true)) return answer(*problem);
    return make(make_cutting_plan(mesh, &before, options));
  } catch (const std::exception&) {
    return answer("There is not enough memory for this in the browser.");
  }
}

/// `face`: the panel to draw if it is in the scope; `map`: whether the map is wanted.
val cutting_preview(const val& base, const val& offsets, const val& vertices, const val& moved,
                    const val& moved_positions, const val& options, int face, bool map) {
  return with_plan(
      base, offsets, vertices, moved, moved_positions, options,
      [&](const CuttingPlan& plan) { return to_value(planish::preview_cutting(plan, face, map)); });
}

val panel_rows(const val& base, const val& offsets, const val& vertices, const val& moved,
               const val& moved_positions, const val& options) {
  return with_plan(base, offsets, vertices, moved, moved_positions, options,
                   [](const CuttingPlan& plan) {
                     val result = answer("");
                     result.set("csv", planish::panel_table(plan).csv);
                     return result;
                   });
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_shop_preview) {
  emscripten::function("cuttingPreview", &cutting_preview);
  emscripten::function("panelRows", &panel_rows);
}
