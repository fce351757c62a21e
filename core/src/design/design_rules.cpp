// SPDX-License-Identifier: MIT
/// What a design must keep; see edit_rules.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "planish/design/design.hpp"

namespace planish {
namespace {

Refusal find_problem(const DesignVariation& variation) {
  if (auto problem = planish::find_problem(variation.options)) return problem;
  if (variation.coefficients.size() > static_cast<std::size_t>(variation.options.dimension)) {
    return "coefficients must be at most as many as dimension";
  }
  if (!(variation.exact_fairness >= 0.0) || !std::isfinite(variation.exact_fairness)) {
    return "smooth must be a number of at least 0";
  }
  const bool known =
      std::all_of(variation.close.begin(), variation.close.end(), [](int v) { return v >= 0; });
  if (!known) return "close must be vertices, from 0";
  const bool finite = std::all_of(variation.coefficients.begin(), variation.coefficients.end(),
                                  [](double x) { return std::isfinite(x); });
  return finite ? std::nullopt : std::optional<std::string>("coefficients must be finite");
}

}  // namespace

Refusal find_problem(const Design& design) {
  constexpr std::array<std::string_view, 6> kUnits = {"mm", "cm", "m", "km", "in", "ft"};
  if (std::find(kUnits.begin(), kUnits.end(), design.unit) == kUnits.end()) {
    return "unit must be mm, cm, m, km, in or ft";
  }
  if (design.planarised) {
    if (auto problem = find_problem(*design.planarised)) return "planarised: " + *problem;
  }
  for (const Cut& cut : design.cuts) {
    if (auto problem = planish::find_problem(cut)) return "cuts: " + *problem;
  }
  if (auto problem = find_problem(design.options)) return "options: " + *problem;
  if (auto problem = find_problem(design.targets.supports)) return problem;
  if (auto problem = find_continuation_problem(design.targets)) return problem;
  if (auto problem =
          find_engine_problem(design.options, design.targets, !design.symmetry.empty())) {
    return problem;
  }
  if (!design.variations.empty()) {
    if (auto problem = find_variation_problem(design.options)) return problem;
  }
  for (std::size_t k = 0; k < design.variations.size(); ++k) {
    if (const auto problem = find_problem(design.variations[k])) {
      return "variations[" + std::to_string(k) + "]: " + *problem;
    }
  }
  return std::nullopt;
}

}  // namespace planish
