// SPDX-License-Identifier: MIT
/// The edit of a session's mesh that makes few panels again, as JavaScript sees it: a list.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <string>

#include "arrays.hpp"
#include "session.hpp"

namespace {

using emscripten::val;
using planish::copy;
using planish::Session;

std::string fewest(Session& s, const val& handles, const val& pins, double within_handle,
                   int most_panels) {
  planish::FewestOptions asked;
  asked.within_handle = within_handle;
  asked.most_panels = most_panels;
  return planish::attempt([&] { return s.fewest(planish::to_targets(handles, pins), asked); });
}

val fewest_found(const Session& s) {
  const planish::FewestEdit& found = s.fewest_found().edit;
  val value = val::object();
  value.set("panels", found.panels);
  value.set("held", copy(found.held));
  value.set("reached", found.reached);
  value.set("minimal", found.minimal);
  value.set("solves", found.solves);
  value.set("limits",
            planish::list_of(s.fewest_found().options.bounds, planish::stated_limit_text));
  return value;
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_fewest) {
  emscripten::function("fewest", &fewest);
  emscripten::function("fewestFound", &fewest_found);
}
