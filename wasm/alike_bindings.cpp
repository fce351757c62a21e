// SPDX-License-Identifier: MIT
/// One more function of the module of documents: a mesh with more of its panels alike. No exception
/// leaves it.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arrays.hpp"
#include "planish/io/obj.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/repetition/fewer_types.hpp"
#include "shop_values.hpp"

namespace {

using emscripten::val;
using planish::FewerTypes;
using planish::FewerTypesOptions;
using planish::Flow;
using planish::IterationRecord;
using planish::Mesh;
using planish::Progress;
using planish::refused;
using planish::StatedLimit;

std::vector<StatedLimit> to_limits(const val& texts) {
  std::vector<StatedLimit> limits;
  for (const val& text : emscripten::vecFromJSArray<val>(texts)) {
    limits.push_back(planish::parse_stated_limit(text.as<std::string>()).value());
  }
  return planish::bounds_of_fewer_types(std::move(limits));
}

/// Lengths are asked for as shares of the mean edge.
FewerTypesOptions to_options(const val& asked, double edge) {
  FewerTypesOptions options;
  options.most_types = asked["types"].as<int>();
  if (options.most_types == 0) options.within = edge * asked["within"].as<double>();
  options.move = edge * asked["move"].as<double>();
  options.mirrored = asked["mirrored"].as<bool>();
  options.tolerance = asked["tolerance"].as<double>();
  options.bounds = to_limits(asked["limits"]);
  return options;
}

val to_value(Mesh mesh, FewerTypes found) {
  mesh.positions = std::move(found.positions);
  val value = refused("");
  value.set("before", found.before);
  value.set("after", static_cast<int>(found.types.families.size()));
  value.set("reached", found.reached);
  value.set("within", found.within);
  value.set("share", found.within / planish::mean_edge_length(mesh));
  value.set("maxMove", found.max_move);
  value.set("file", planish::copy(planish::write_obj(mesh)));
  return value;
}

/// `obj`: of a design; `say`: called with the number of steps so far.
val alike(const std::string& obj, const val& asked, const val& say) {
  try {
    auto read = planish::read_obj(obj);
    if (const auto* error = std::get_if<planish::ReadError>(&read)) return refused(error->message);
    Mesh& mesh = std::get<planish::MeshFile>(read).mesh;
    const FewerTypesOptions options = to_options(asked, planish::mean_edge_length(mesh));
    if (const auto problem = find_problem(options, mesh)) return refused(*problem);
    const bool keep = asked["keepBoundary"].as<bool>();
    const auto pins = keep ? planish::boundary_vertices(mesh) : std::vector<int>();
    const Progress progress = [&say](const IterationRecord& record) {
      say(record.step);
      return Flow::kContinue;
    };
    FewerTypes found = find_fewer_types(mesh, options, pins, progress);
    return to_value(std::move(mesh), std::move(found));
  } catch (const std::exception&) {
    return refused("there is not enough memory for this in the browser");
  }
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_alike) { emscripten::function("alike", &alike); }
