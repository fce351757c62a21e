// SPDX-License-Identifier: MIT
/// What a choice of planarising must keep; apart from the solver, which readers of designs do not
/// need.
#include <cmath>

#include "planish/projection/planarising.hpp"

namespace planish {

Refusal find_problem(const Planarising& how) {
  if (!std::isfinite(how.fairness_weight) || how.fairness_weight < 0.0) {
    return "smooth must be a number of at least 0";
  }
  if (!std::isfinite(how.within) || how.within < 0.0) {
    return "within must be a length of at least 0";
  }
  if (!std::isfinite(how.flat_within) || how.flat_within < 0.0) {
    return "flat must be a number of at least 0 (mm/m)";
  }
  return find_problem(how.constraints);
}

}  // namespace planish
