// SPDX-License-Identifier: MIT
/// Panels parted for what a solve asks, as JavaScript sees it: a list.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <string>
#include <variant>

#include "arrays.hpp"
#include "design_values.hpp"
#include "session.hpp"

namespace {

using emscripten::val;
using planish::refused;
using planish::Session;

val to_value(const planish::SplitStanding& standing) {
  val value = val::object();
  value.set("lines", standing.lines);
  value.set("cuts", planish::list_of(standing.cuts, planish::cut_text));
  value.set("handleError", standing.handle_error);
  value.set("movedVertices", standing.moved_vertices);
  value.set("remadePanels", standing.remade_panels);
  value.set("sharpestFold", standing.sharpest_fold);
  return value;
}

val to_value(const planish::SplitEdit& found) {
  val value = refused("");
  value.set("curve", planish::list_of(found.curve, [](const auto& one) { return to_value(one); }));
  value.set("tried", found.solves);
  value.set("reached", found.reached);
  return value;
}

val split_where_needed(Session& s, const val& handles, const val& pins, int most,
                       const val& found_one) {
  try {
    planish::SplitOptions options;
    options.most_cuts = most;
    options.found = [&](const planish::SplitStanding& standing) { found_one(to_value(standing)); };
    auto found = s.split_where_needed(planish::to_targets(handles, pins), options);
    const auto* problem = std::get_if<std::string>(&found);
    return problem != nullptr ? refused(*problem) : to_value(std::get<planish::SplitEdit>(found));
  } catch (const std::exception& error) {
    return refused(std::string("Internal error: ") + error.what());
  }
}

std::string split_until_flat(Session& s, const val& how, int most) {
  return planish::attempt([&] { return s.split_until_flat(planish::to_planarising(how), most); });
}

int split_panels(const Session& s) { return s.hybrid().panels; }

}  // namespace

EMSCRIPTEN_BINDINGS(planish_splitting) {
  emscripten::function("splitWhereNeeded", &split_where_needed);
  emscripten::function("splitUntilFlat", &split_until_flat);
  emscripten::function("splitPanels", &split_panels);
}
