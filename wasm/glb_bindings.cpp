// SPDX-License-Identifier: MIT
/// Files as JavaScript sees them: GLB, and designs as text. No exception leaves it.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "design_values.hpp"
#include "glb_file.hpp"
#include "planish/design/design_text.hpp"
#include "planish/mesh/point_joining.hpp"

namespace {

using emscripten::val;
using planish::copy;
using planish::GlbContent;
using planish::GlbVariations;
using planish::OpenedGlb;
using planish::Positions;
using planish::refused;
using planish::to_positions;

constexpr const char* kNoMemory = "There is not enough memory for this file in the browser.";

/// The design, or why the text is none.
val read_design(const std::string& text) {
  try {
    const auto read = planish::read_design(text);
    if (const auto* sentence = std::get_if<std::string>(&read)) return refused(*sentence);
    val result = refused("");
    result.set("design", to_value(std::get<planish::Design>(read)));
    return result;
  } catch (const std::exception&) {
    return refused(kNoMemory);
  }
}

std::string write_design(const val& design, planish::FileText file) {
  try {
    return planish::write_design(planish::to_design(design), file);
  } catch (const std::exception&) {
    return "";
  }
}

val to_object(const OpenedGlb& opened) {
  val result = refused("");
  result.set("mesh", copy(opened.mesh));
  result.set("stored", opened.design.empty() ? val::null() : read_design(opened.design));
  result.set("moved", copy(opened.moved));
  result.set("positions", copy(opened.positions));
  result.set("warnings", val::array(opened.warnings));
  return result;
}

val open(const std::string& bytes) {
  try {
    const auto opened = planish::open_glb(bytes);
    if (const auto* sentence = std::get_if<std::string>(&opened)) return refused(*sentence);
    return to_object(std::get<OpenedGlb>(opened));
  } catch (const std::exception&) {
    return refused(kNoMemory);
  }
}

/// `displacements` holds 3 × |support| numbers for each variation, one after the other.
GlbVariations to_variations(const val& support, const val& displacements) {
  GlbVariations variations{planish::to_indices(support), {}};
  const Positions all = to_positions(displacements);
  const auto rows = static_cast<Eigen::Index>(variations.support.size());
  for (Eigen::Index first = 0; rows > 0 && first + rows <= all.cols(); first += rows) {
    variations.displacements.emplace_back(all.middleCols(first, rows));
  }
  return variations;
}

/// `offset`: 3 numbers for each vertex of a second layer, or none.
val assemble(const std::string& mesh, const val& base, const val& support, const val& displacements,
             const val& offset, const val& design) {
  try {
    GlbContent content{.base = to_positions(base),
                       .variations = {},
                       .design = write_design(design, planish::FileText::kBase64)};
    if (Positions layer = to_positions(offset); layer.cols() > 0) content.offset = layer;
    GlbVariations variations = to_variations(support, displacements);
    if (!variations.displacements.empty()) content.variations = std::move(variations);
    return copy(planish::assemble_glb(mesh, content));
  } catch (const std::exception&) {
    return copy(std::string());
  }
}

/// OBJ in and out; no bytes where there is no memory.
val mend(const std::string& mesh, const std::string& way) {
  try {
    return copy(planish::mended(mesh, way));
  } catch (const std::exception&) {
    return copy(std::string());
  }
}

/// Of each point the one it is joined to; empty where there is no memory.
val joined_points(const val& points, double within) {
  try {
    return copy(planish::find_joined_points(to_positions(points), within).target);
  } catch (const std::exception&) {
    return copy(std::vector<int>());
  }
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_glb) {
  emscripten::function("openGlb", &open);
  emscripten::function("assembleGlb", &assemble);
  emscripten::function("mend", &mend);
  emscripten::function("joinedPoints", &joined_points);
  emscripten::function("readDesign", &read_design);
  emscripten::function(
      "writeDesign",
      +[](const val& design) { return write_design(design, planish::FileText::kBase64); });
  emscripten::function(
      "writeLinkText",
      +[](const val& design) { return write_design(design, planish::FileText::kPlain); });
  emscripten::function("defaults", &planish::defaults_value);
}
