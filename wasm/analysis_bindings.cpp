// SPDX-License-Identifier: MIT
/// What is measured on a design, as JavaScript sees it: a list. Memory that runs out ends the
/// module, and with it the worker, which is replaced.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis.hpp"
#include "arrays.hpp"

namespace {

using emscripten::val;
using planish::Analysis;
using planish::copy;
using planish::EditFreedom;
using planish::FairnessKind;
using planish::to_indices;
using planish::to_mesh;
using planish::to_positions;

/// `opened`: as it was before it was planarised, empty if it was not.
Analysis* create(const val& positions, const val& offsets, const val& vertices, const val& opened) {
  // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): embind owns it
  return new Analysis(to_mesh(positions, offsets, vertices), to_positions(opened));
}
void show(Analysis& a, const val& moved, const val& positions) {
  a.show(to_indices(moved), to_positions(positions));
}
/// A copy of what is measured.
template <auto kMeasure>
val measured(const Analysis& a) {
  return copy((a.*kMeasure)());
}
val nodes_to_remake(const Analysis& a) {
  const auto [moved, arms] = a.nodes_to_remake();
  val object = val::object();
  object.set("moved", moved);
  object.set("arms", arms);
  return object;
}
val defects(const Analysis& a, const std::string& kind) { return copy(a.defects(kind)); }
val vertex_bending(const Analysis& a, FairnessKind kind) { return copy(a.vertex_bending(kind)); }
/// `moves`: 3 × |support| numbers for each slider.
void set_family(Analysis& a, const val& moved, const val& positions, const val& support,
                const val& moves) {
  std::vector<int> points = to_indices(support);
  const auto flat = emscripten::convertJSArrayToNumberVector<double>(moves);
  const auto rows = static_cast<Eigen::Index>(3 * points.size());
  const auto sliders = rows > 0 ? static_cast<Eigen::Index>(flat.size()) / rows : 0;
  a.set_family(to_indices(moved), to_positions(positions), std::move(points),
               Eigen::Map<const Eigen::MatrixXd>(flat.data(), rows, sliders));
}
val slider_stops(const Analysis& a, const val& values) {
  return copy(a.slider_stops(planish::to_vector(values)));
}
/// A plain object; null where there is none.
val to_value(const std::optional<EditFreedom>& freedom) {
  if (!freedom) return val::null();
  val object = val::object();
  object.set("points", freedom->points);
  object.set("equations", freedom->equations);
  object.set("rank", freedom->rank);
  object.set("freedom", freedom->freedom());
  object.set("borne", freedom->borne);
  object.set("holding", list_of(freedom->holding, [](const auto& panel) { return panel.face; }));
  return object;
}
val freedom(const Analysis& a, const val& handles, const val& pins) {
  return to_value(a.freedom(planish::to_targets(handles, pins)));
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_analysis) {
  emscripten::enum_<FairnessKind>("FairnessKind")
      .value("laplacian", FairnessKind::kLaplacian)
      .value("second", FairnessKind::kSecondDifference)
      .value("third", FairnessKind::kThirdDifference);
  emscripten::class_<Analysis>("Analysis")
      .constructor(&create, emscripten::allow_raw_pointers())
      .function("show", &show)
      .function("panelFigures", &measured<&Analysis::panel_figures>)
      .function("panelHealth", &measured<&Analysis::panel_health>)
      .function("nodesToRemake", &nodes_to_remake)
      .function("panelDamage", &measured<&Analysis::panel_damage>)
      .function("panelFolds", &measured<&Analysis::panel_folds>)
      .function("defects", &defects)
      .function("vertexBending", &vertex_bending)
      .function("setFamily", &set_family)
      .function("sliderStops", &slider_stops)
      .function("freedom", &freedom);
}
