// SPDX-License-Identifier: MIT
#include "planish/constraints/kept_constraint.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace planish {
namespace {

std::string known_kinds() {
  std::string names;
  ConstraintKinds::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    if (Kind::kName == PlanarPolygon::kName || names.ends_with(Kind::kName)) return;
    names += (names.empty() ? "" : ", ") + std::string(Kind::kName);
  });
  return names;
}

}  // namespace

Refusal find_problem(const std::vector<KeptConstraint>& constraints) {
  std::vector<std::string_view> seen;
  for (const KeptConstraint& constraint : constraints) {
    if (constraint.kind == PlanarPolygon::kName) {
      return "constraints: planar is always kept; tolerance is how exactly";
    }
    if (!own_tolerance(constraint.kind))
      return "constraints: a kind must be one of " + known_kinds();
    if (!(constraint.tolerance > 0.0) || !std::isfinite(constraint.tolerance)) {
      return "constraints: the tolerance of " + constraint.kind + " must be greater than 0";
    }
    if (std::find(seen.begin(), seen.end(), constraint.kind) != seen.end()) {
      return "constraints: " + constraint.kind + " is given twice";
    }
    seen.push_back(constraint.kind);
  }
  return std::nullopt;
}

KeptKinds kept_kinds(double tolerance, const std::vector<KeptConstraint>& constraints) {
  KeptKinds kept(tolerance);
  for (const KeptConstraint& constraint : constraints) {
    kept.keep(constraint.kind, constraint.tolerance);
  }
  return kept;
}

}  // namespace planish
