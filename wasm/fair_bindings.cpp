// SPDX-License-Identifier: MIT
/// The edit of a session's mesh with limits that cost its handles nothing, as JavaScript sees it: a
/// list.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <string>

#include "arrays.hpp"
#include "session.hpp"

namespace {

using emscripten::val;
using planish::EditMode;
using planish::Session;

std::string edit_fairly(Session& s, EditMode mode, const val& handles, const val& pins,
                        int continuation, double budget, const val& sought) {
  const planish::FairSearch search{.way = sought["way"].as<double>(),
                                   .folds = sought["folds"].as<bool>(),
                                   .corners = sought["corners"].as<bool>()};
  return planish::attempt([&] {
    return s.edit_fairly(mode, planish::to_targets(handles, pins, continuation), budget, search);
  });
}

val fair_found(const Session& s) {
  return planish::list_of(s.fair_found(), planish::stated_limit_text);
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_fair) {
  emscripten::function("editFairly", &edit_fairly);
  emscripten::function("fairFound", &fair_found);
}
