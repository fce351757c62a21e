// SPDX-License-Identifier: MIT
#include "shop_values.hpp"

#include <emscripten/val.h>

#include "arrays.hpp"

namespace planish::shop {

using emscripten::val;

ShopDesign to_design(const val& design) {
  ShopDesign result;
  result.base = to_mesh(design["base"], design["offsets"], design["vertices"]);
  result.mesh = result.base;
  const auto moved = to_indices(design["moved"]);
  result.mesh.positions(Eigen::all, moved) = to_positions(design["movedPositions"]);
  result.names = PanelNames(to_indices(design["parents"]));
  return result;
}

CuttingOptions to_cutting_options(const val& options, const ShopDesign& design) {
  CuttingOptions result;
  result.names = design.names;
  result.name = options["name"].as<std::string>();
  result.model_unit = options["modelUnit"].as<std::string>();
  result.unit = options["unit"].as<std::string>();
  result.gap = options["gap"].as<double>();
  result.thickness = options["thickness"].as<double>();
  result.sheet_width = options["sheetWidth"].as<double>();
  result.sheet_height = options["sheetHeight"].as<double>();
  result.text_height = options["textHeight"].as<double>();
  if (const double by = options["jointBy"].as<double>(); by != 0.0) {
    result.types.emplace();
    result.types->joint = JointRange{result.gap - by, result.gap + by};
    result.types->mirrored = options["mirrored"].as<bool>();
    result.gap = 0.5 * (result.types->joint->min + result.types->joint->max);
  }
  result.by_type = options["byType"].as<bool>();
  result.remake_only = options["remakeOnly"].as<bool>();
  result.panels = emscripten::convertJSArrayToNumberVector<int>(options["panels"]);
  return result;
}

}  // namespace planish::shop
