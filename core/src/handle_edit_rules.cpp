// SPDX-License-Identifier: MIT
/// What options and targets of an edit must keep. Apart from the solver, so that whoever reads
/// designs needs no solver.
#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "planish/handle_edit.hpp"

namespace planish {
Refusal find_problem(const HandleEditOptions& options) {
  const auto weight = [](double value) { return std::isfinite(value) && value >= 0.0; };
  if (!weight(options.attraction) || options.attraction == 0.0) {
    return "attraction must be a number greater than 0";
  }
  if (!weight(options.locality)) return "locality must be a number of at least 0";
  if (!weight(options.smoothness)) return "smoothness must be a number of at least 0";
  if (options.reach < 0) return "reach must be at least 0 (face rings)";
  if (!weight(options.reach_length)) return "reach_length must be a number of at least 0";
  const bool on_scale = options.softness >= kHardest && options.softness <= kSoftest;
  if (options.softness != 0.0 && !on_scale) return "softness must be 0 (off) or from 1 to 10";
  if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance)) {
    return "tolerance must be a number greater than 0 (mm/m)";
  }
  if (auto problem = find_problem(options.constraints)) return problem;
  if (auto problem = find_problem(options.bounds)) return problem;
  if (options.max_iterations < 0) return "max_iterations must be at least 0";
  return std::nullopt;
}

Refusal find_continuation_problem(const EditTargets& targets) {
  const bool in_range = targets.continuation >= 0 && targets.continuation <= kMostContinuation;
  if (!in_range) return "continuation must be 0 (at once) or from 1 to 1000 steps";
  return std::nullopt;
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
