// SPDX-License-Identifier: MIT
/// The GLB module as JavaScript sees it: two functions. No exception leaves it.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <string>
#include <vector>

#include "glb_file.hpp"

namespace {

using emscripten::val;
using planish::GlbContent;
using planish::GlbVariations;
using planish::OpenedGlb;
using planish::Positions;

template <class T>
val copy(const T* data, std::size_t count) {
  return val(emscripten::typed_memory_view(count, data)).call<val>("slice");
}

val bytes_of(const std::string& text) {
  return copy(reinterpret_cast<const unsigned char*>(text.data()), text.size());
}

Positions to_positions(const val& numbers) {
  const auto flat = emscripten::convertJSArrayToNumberVector<double>(numbers);
  return Eigen::Map<const Positions>(flat.data(), 3, static_cast<Eigen::Index>(flat.size() / 3));
}

val problem(const std::string& sentence) {
  val result = val::object();
  result.set("problem", sentence);
  return result;
}

val to_object(const OpenedGlb& opened) {
  val result = problem("");
  val warnings = val::array();
  for (const std::string& warning : opened.warnings) warnings.call<void>("push", warning);
  result.set("mesh", bytes_of(opened.mesh));
  result.set("design", opened.design);
  result.set("moved", copy(opened.moved.data(), opened.moved.size()));
  result.set("positions",
             copy(opened.positions.data(), static_cast<std::size_t>(opened.positions.size())));
  result.set("warnings", warnings);
  return result;
}

val open(const std::string& bytes) {
  try {
    const auto opened = planish::open_glb(bytes);
    if (const auto* sentence = std::get_if<std::string>(&opened)) return problem(*sentence);
    return to_object(std::get<OpenedGlb>(opened));
  } catch (const std::exception&) {
    return problem("There is not enough memory for this file in the browser.");
  }
}

/// `displacements` holds 3 × |support| numbers for each variation, one after the other.
GlbVariations to_variations(const val& support, const val& displacements) {
  GlbVariations variations{emscripten::convertJSArrayToNumberVector<int>(support), {}};
  const Positions all = to_positions(displacements);
  const auto rows = static_cast<Eigen::Index>(variations.support.size());
  for (Eigen::Index first = 0; rows > 0 && first + rows <= all.cols(); first += rows) {
    variations.displacements.emplace_back(all.middleCols(first, rows));
  }
  return variations;
}

val assemble(const std::string& mesh, const val& base, const val& support, const val& displacements,
             const std::string& design) {
  try {
    GlbContent content{.base = to_positions(base), .variations = {}, .design = design};
    GlbVariations variations = to_variations(support, displacements);
    if (!variations.displacements.empty()) content.variations = std::move(variations);
    return bytes_of(planish::assemble_glb(mesh, content));
  } catch (const std::exception&) {
    return bytes_of("");
  }
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_glb) {
  emscripten::function("openGlb", &open);
  emscripten::function("assembleGlb", &assemble);
}
