// SPDX-License-Identifier: MIT
/// Where a mesh can move, as JavaScript sees it: a list. Memory that runs out ends the module, and
/// with it the worker that measures.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <memory>
#include <utility>

#include "arrays.hpp"
#include "design_values.hpp"
#include "mobility_map.hpp"
#include "mobility_values.hpp"

namespace {

using emscripten::val;
using planish::Mesh;
using planish::MobilityMap;

/// {map}, or {problem} with one sentence. @param settings of the page's edits
val open_map(const val& positions, const val& offsets, const val& vertices, const val& settings) {
  Mesh mesh = planish::to_mesh(positions, offsets, vertices);
  const auto options = planish::map_options(planish::to_options(settings));
  if (const auto problem = planish::find_map_problem(mesh, options)) {
    return planish::refused(*problem);
  }
  val answer = val::object();
  answer.set("map", std::make_shared<MobilityMap>(std::move(mesh), options));
  return answer;
}
val measure(MobilityMap& map, int vertex) { return planish::to_value(map.measure(vertex)); }
val best(const MobilityMap& map, int count) { return planish::to_value(map.best(count)); }

}  // namespace

EMSCRIPTEN_BINDINGS(planish_mobility) {
  emscripten::class_<MobilityMap>("MobilityMap")
      .smart_ptr<std::shared_ptr<MobilityMap>>("MobilityMapHold")
      .function("measure", &measure)
      .function("best", &best);
  emscripten::function("openMap", &open_map);
}
