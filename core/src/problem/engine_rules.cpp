// SPDX-License-Identifier: MIT
#include <string_view>

#include "planish/problem/engine.hpp"

namespace planish {
namespace {

std::string_view name_of(Beyond beyond) {
  switch (beyond) {
    case Beyond::kSupports:
      return "supports";
    case Beyond::kKeepOuts:
      return "keep_out";
    case Beyond::kSymmetry:
      return "symmetry";
    case Beyond::kContinuation:
      return "continuation";
    case Beyond::kFewest:
      return "fewest";
    case Beyond::kSplits:
      return "splits";
    case Beyond::kMobility:
      return "mobility";
    case Beyond::kBends:
      return "keep_bends";
  }
  return "";
}

}  // namespace

Refusal find_problem(Engine engine, Beyond beyond) {
  if (engine == Engine::kNewton) return std::nullopt;
  const bool several = beyond == Beyond::kSupports || beyond == Beyond::kSplits;
  return std::string(name_of(beyond)) + ": the engine alm knows none; " +
         (several ? "they need" : "it needs") + " newton";
}

}  // namespace planish
