// SPDX-License-Identifier: MIT
/// What options and targets of an edit must keep. Apart from the solver, so that whoever reads
/// designs needs no solver.
#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "planish/edit/edit_option_table.hpp"
#include "planish/edit/handle_edit.hpp"

namespace planish {
namespace {

template <class Number>
Refusal find_wrong_number(const EditOption<Number>& option, double value) {
  if (std::isfinite(value) && option.rule.holds(value)) return std::nullopt;
  return std::string(option.name) + " must be " + std::string(option.rule.sentence);
}

Refusal find_problem(const EditOption<double>& option, double value) {
  return find_wrong_number(option, value);
}

Refusal find_problem(const EditOption<int>& option, int value) {
  return find_wrong_number(option, value);
}

template <class Value>
Refusal find_problem(const EditOption<std::vector<Value>>&, const std::vector<Value>& list) {
  return planish::find_problem(list);
}

/// Words and switches have no wrong value.
template <class Value>
Refusal find_problem(const EditOption<Value>&, const Value&) {
  return std::nullopt;
}

}  // namespace

Refusal find_problem(const HandleEditOptions& options) {
  Refusal problem;
  for_each_edit_option([&](const auto& option) {
    if (!problem) problem = find_problem(option, options.*option.member);
  });
  return problem;
}

Refusal find_continuation_problem(const EditTargets& targets) {
  const bool in_range = targets.continuation >= 0 && targets.continuation <= kMostContinuation;
  if (!in_range) return "continuation must be 0 (at once) or from 1 to 1000 steps";
  return std::nullopt;
}

Refusal find_engine_problem(const HandleEditOptions& options, const EditTargets& targets,
                            bool symmetric) {
  Refusal problem;
  const auto ask_for = [&](Beyond beyond, bool asked) {
    if (asked && !problem) problem = find_problem(options.engine, beyond);
  };
  ask_for(Beyond::kContinuation, targets.continuation > 0);
  ask_for(Beyond::kSupports, !targets.supports.empty());
  ask_for(Beyond::kKeepOuts, !options.keep_outs.empty());
  ask_for(Beyond::kSymmetry, symmetric);
  ask_for(Beyond::kBends, options.keep_bends);
  return problem;
}

Refusal find_variation_problem(const HandleEditOptions& options) {
  if (!options.keep_bends) return std::nullopt;
  return "keep_bends: variations make panels flat, so none are found around an edit whose panels "
         "stay bent";
}

Refusal find_problem(const EditTargets& targets, const Mesh& mesh) {
  std::vector<int> seen;
  for (const Handle& handle : targets.handles) {
    const std::string name = "handle " + std::to_string(handle.vertex);
    if (handle.vertex < 0 || handle.vertex >= mesh.vertex_count()) {
      return name + ": the mesh has vertices 0 to " + std::to_string(mesh.vertex_count() - 1);
    }
    if (!handle.target.allFinite()) return name + ": the target is not finite";
    if (handle.target.cwiseAbs().maxCoeff() > kLargestCoordinate) {
      return name + ": the target has a coordinate larger than 1e100";
    }
    seen.push_back(handle.vertex);
  }
  std::sort(seen.begin(), seen.end());
  if (const auto twice = std::adjacent_find(seen.begin(), seen.end()); twice != seen.end()) {
    return "handle " + std::to_string(*twice) + " is given twice";
  }
  for (const int pin : targets.pins) {
    if (pin < 0 || pin >= mesh.vertex_count()) {
      return "pin " + std::to_string(pin) + ": the mesh has vertices 0 to " +
             std::to_string(mesh.vertex_count() - 1);
    }
    if (std::binary_search(seen.begin(), seen.end(), pin)) {
      return "vertex " + std::to_string(pin) + " is both a handle and a pin";
    }
  }
  if (auto problem = find_continuation_problem(targets)) return problem;
  return find_problem(targets.supports, mesh);
}

}  // namespace planish
