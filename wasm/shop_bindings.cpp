// SPDX-License-Identifier: MIT
/// What the workshop gets, as JavaScript sees it: one function for all files. No exception leaves
/// it.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <string>
#include <string_view>

#include "planish/fabrication/cutting_package.hpp"
#include "planish/fabrication/ifc.hpp"
#include "planish/fabrication/structure_drawings.hpp"
#include "shop_values.hpp"

namespace {

using emscripten::val;
using planish::ByteSink;
using planish::CuttingOptions;
using planish::DrawingOptions;
using planish::LinkCode;
using planish::Refusal;
using planish::refused;
using planish::shop::ShopDesign;
using planish::shop::to_cutting_options;
using planish::shop::to_design;

LinkCode to_code(const val& code) {
  LinkCode result;
  result.link = code["link"].as<std::string>();
  result.size = code["size"].as<int>();
  result.dark = emscripten::convertJSArrayToNumberVector<char>(code["dark"]);
  return result;
}

DrawingOptions to_drawing_options(const val& options) {
  DrawingOptions result;
  result.name = options["name"].as<std::string>();
  result.model_unit = options["modelUnit"].as<std::string>();
  result.unit = options["unit"].as<std::string>();
  result.scale = options["scale"].as<double>();
  const auto planes = emscripten::convertJSArrayToNumberVector<double>(options["sections"]);
  for (std::size_t k = 0; k + 4 <= planes.size(); k += 4) {
    result.sections.push_back({{planes[k], planes[k + 1], planes[k + 2]}, planes[k + 3]});
  }
  return result;
}

/// Adds axes and levels as the command line's --axis says them.
Refusal add_axes(DrawingOptions& options, const val& texts) {
  for (const val& given : emscripten::vecFromJSArray<val>(texts)) {
    const auto text = given.as<std::string>();
    const auto axis = planish::parse_drawing_axis(text);
    if (!axis) return "axis \"" + text + "\" is not " + std::string(planish::kDrawingAxisForm);
    options.axes.push_back(*axis);
  }
  return std::nullopt;
}

/// Hands `take` a view of each piece.
ByteSink to_sink(const val& take) {
  return [take](std::string_view piece) {
    const auto* data = reinterpret_cast<const unsigned char*>(piece.data());
    take(val(emscripten::typed_memory_view(piece.size(), data)));
  };
}

/// @param header JSON, as a file has it; an object in JavaScript
val written(const std::string& header) {
  val result = refused("");
  result.set("header", val::global("JSON").call<val>("parse", header));
  return result;
}

val write_package(const ShopDesign& design, const val& order, const ByteSink& sink) {
  const CuttingOptions options = to_cutting_options(order["options"], design);
  if (design.mesh.face_count() > planish::kMostPackagePanels) {
    return refused("A cutting package holds at most 60,000 panels.");
  }
  if (const Refusal problem = find_problem(options, design.mesh, true)) {
    return refused("The cutting package was refused: " + *problem + ".");
  }
  const auto package = planish::write_cutting_package(design.mesh, &design.base, options, sink,
                                                      to_code(order["code"]));
  return written(package.header);
}

val write_model(const ShopDesign& design, const val& order, const ByteSink& sink) {
  const CuttingOptions options = to_cutting_options(order["options"], design);
  if (const Refusal problem = find_problem(options, design.mesh, true)) {
    return refused("The model was refused: " + *problem + ".");
  }
  const auto plan = planish::make_cutting_plan(design.mesh, &design.base, options);
  const auto model = planish::write_ifc(plan);
  sink(model.text);
  return written(model.header);
}

val write_views(const ShopDesign& design, const val& order, const ByteSink& sink) {
  DrawingOptions options = to_drawing_options(order["options"]);
  options.names = design.names;
  const Refusal unread = add_axes(options, order["options"]["axes"]);
  if (const Refusal problem = unread ? unread : find_problem(options, design.mesh)) {
    return refused("The drawings were refused: " + *problem + ".");
  }
  const auto drawings = planish::write_drawings(design.mesh, options);
  sink(drawings.zip);
  return written(drawings.header);
}

val write(const val& design, const val& order, const val& take) {
  return planish::shop::in_memory([&] {
    const ByteSink sink = to_sink(take);
    const ShopDesign given = to_design(design);
    const auto what = order["what"].as<std::string>();
    if (what == "ifc") return write_model(given, order, sink);
    if (what == "drawings") return write_views(given, order, sink);
    return write_package(given, order, sink);
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_shop) { emscripten::function("write", &write); }
