// SPDX-License-Identifier: MIT
/// The module that writes cutting packages, as JavaScript sees it: one function. No exception
/// leaves it.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <string>
#include <utility>

#include "planish/fabrication/cutting_package.hpp"

namespace {

using emscripten::val;
using planish::CuttingOptions;
using planish::CuttingPackage;
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

val write(const Mesh& base, const Positions& positions, const CuttingOptions& options) {
  Mesh mesh = base;
  mesh.positions = positions;
  if (mesh.face_count() > planish::kMostPackagePanels) {
    return answer("A cutting package holds at most 60,000 panels.");
  }
  if (const auto problem = find_problem(options, mesh, true)) {
    return answer("The cutting package was refused: " + *problem + ".");
  }
  const CuttingPackage package = planish::write_cutting_package(mesh, &base, options);
  const auto* bytes = reinterpret_cast<const unsigned char*>(package.zip.data());
  val result = answer("");
  result.set("zip",
             val(emscripten::typed_memory_view(package.zip.size(), bytes)).call<val>("slice"));
  result.set("header", package.header);
  return result;
}

/// `moved`: the vertices that do not lie as in `base`, where they lie instead.
val cutting_package(const val& base, const val& offsets, const val& vertices, const val& moved,
                    const val& moved_positions, const val& options) {
  try {
    Mesh mesh;
    mesh.positions = to_positions(base);
    mesh.face_offsets = emscripten::convertJSArrayToNumberVector<int>(offsets);
    mesh.face_vertices = emscripten::convertJSArrayToNumberVector<int>(vertices);
    Positions positions = mesh.positions;
    const auto indices = emscripten::convertJSArrayToNumberVector<int>(moved);
    positions(Eigen::all, indices) = to_positions(moved_positions);
    return write(mesh, positions, to_options(options));
  } catch (const std::exception&) {
    return answer("There is not enough memory for this package in the browser.");
  }
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_shop) { emscripten::function("cuttingPackage", &cutting_package); }
