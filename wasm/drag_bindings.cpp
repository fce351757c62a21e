// SPDX-License-Identifier: MIT
/// Frames of a drag, and how far a pull gets, as JavaScript sees them: a list.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <string>
#include <vector>

#include "arrays.hpp"
#include "session.hpp"

namespace {

using emscripten::val;
using planish::Handle;
using planish::PullLimit;
using planish::PullWay;
using planish::Session;
using planish::to_handles;
using planish::to_targets;

PullLimit to_limit(const val& limit) {
  PullLimit pull{.short_share = limit["short"].as<double>(), .from = to_handles(limit["from"])};
  if (const val tries = limit["tries"]; !tries.isUndefined()) pull.tries = tries.as<int>();
  return pull;
}

/// Vertex, x, y, z for each.
val to_value(const std::vector<Handle>& handles) {
  std::vector<double> numbers(4 * handles.size());
  for (std::size_t k = 0; k < handles.size(); ++k) {
    numbers[4 * k] = handles[k].vertex;
    for (int axis = 0; axis < 3; ++axis) {
      numbers[4 * k + 1 + static_cast<std::size_t>(axis)] = handles[k].target[axis];
    }
  }
  return planish::copy(numbers);
}

val pull(Session& s, PullWay way, const val& handles, const val& pins, int continuation,
         double budget, const val& limit) {
  const std::string problem = planish::attempt([&] {
    return s.pull(way, to_targets(handles, pins, continuation), budget, to_limit(limit));
  });
  const planish::Pulled& pulled = s.pulled();
  val value = val::object();
  value.set("problem", problem);
  value.set("suffices", pulled.suffices);
  value.set("taken", pulled.taken ? to_value(*pulled.taken) : val::null());
  return value;
}

val pull_standing(const Session& s, const val& handles, const val& limit) {
  const planish::PullStanding standing = s.pull_standing(to_limit(limit), to_handles(handles));
  val value = val::object();
  value.set("isStuck", standing.is_stuck);
  value.set("isBound", standing.is_bound);
  value.set("arrives", standing.arrives);
  value.set("lags", standing.lags);
  return value;
}

val last_pull(const Session& s, const val& from, const val& to) {
  const planish::PullHold& hold = s.pull_hold();
  val value = val::object();
  value.set("goesOn", hold.goes_on(to_handles(from)));
  value.set("isHeldBack", hold.held_back_from(to_handles(to)));
  value.set("taken", to_value(hold.taken()));
  return value;
}

bool suffices(const Session& s, double way, double most) {
  return planish::suffices(s.standing(), way, most);
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish_drag) {
  emscripten::enum_<PullWay>("PullWay")
      .value("follow", PullWay::kFollow)
      .value("near", PullWay::kNear)
      .value("hold", PullWay::kHold)
      .value("release", PullWay::kRelease)
      .value("furthest", PullWay::kFurthest);
  emscripten::function("pull", &pull);
  emscripten::function("pullStanding", &pull_standing);
  emscripten::function("lastPull", &last_pull);
  emscripten::function("suffices", &suffices);
  emscripten::function("forgetDrag",
                       emscripten::optional_override([](Session& s) { s.forget_drag(); }));
}
