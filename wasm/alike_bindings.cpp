// SPDX-License-Identifier: MIT
/// Panels made more alike, as JavaScript sees it: a list.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <string>
#include <variant>

#include "arrays.hpp"
#include "session.hpp"

namespace {

using emscripten::val;
using planish::Session;

val with_problem(const std::string& problem) {
  val value = val::object();
  value.set("problem", problem);
  return value;
}

val alike(const Session& s, const val& asked) {
  try {
    const auto found = s.alike({.within = asked["within"].as<double>(),
                                .move = asked["move"].as<double>(),
                                .mirrored = asked["mirrored"].as<bool>(),
                                .keep_boundary = asked["keepBoundary"].as<bool>()});
    if (const auto* problem = std::get_if<std::string>(&found)) return with_problem(*problem);
    const auto& mesh = std::get<planish::AlikeMesh>(found);
    val value = with_problem("");
    value.set("before", mesh.before);
    value.set("after", mesh.after);
    value.set("maxMove", mesh.max_move);
    value.set("file", planish::copy(mesh.obj));
    return value;
  } catch (const std::exception& error) {
    return with_problem(std::string("Internal error: ") + error.what());
  }
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_alike) { emscripten::function("alike", &alike); }
