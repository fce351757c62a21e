// SPDX-License-Identifier: MIT
/// What options of a family of variations must keep; see edit_rules.cpp.
#include <cmath>

#include "planish/variations/subspace.hpp"

namespace planish {

Refusal find_problem(const SubspaceOptions& options) {
  constexpr int kMostDimensions = 24;
  const auto weight = [](double value) { return std::isfinite(value) && value >= 0.0; };
  if (options.dimension < 1 || options.dimension > kMostDimensions) {
    return "dimension must be 1 to " + std::to_string(kMostDimensions);
  }
  if (!weight(options.fairness_weight)) return "fairness_weight must be a number of at least 0";
  if (!weight(options.sparsity_weight) || options.sparsity_weight == 0.0) {
    return "sparsity_weight must be a number greater than 0";
  }
  if (!weight(options.closeness_weight)) return "closeness_weight must be a number of at least 0";
  if (!weight(options.correlation) || options.correlation >= 1.0) {
    return "correlation must be at least 0 and less than 1";
  }
  const bool wider = options.family >= options.dimension && options.family <= kMostDimensions;
  if (options.family != 0 && !wider) {
    return "family must be dimension to " + std::to_string(kMostDimensions) + ", or 0";
  }
  if (options.family != 0 && !options.eigenbasis) return "family needs the eigenbasis";
  if (options.reach < 0) return "reach must be at least 0";
  return std::nullopt;
}

}  // namespace planish
