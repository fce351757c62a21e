// SPDX-License-Identifier: MIT
/// The kinds of constraints that someone asks for beside planarity, by name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planish/constraints/kept_kinds.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

/// A kind of constraint that an edit or a projection keeps beside planarity.
struct KeptConstraint {
  std::string kind;        ///< a name of constraints/registry.hpp, for example "circular"
  double tolerance = 0.0;  ///< largest measure of a finished mesh, > 0, in the kind's unit

  friend bool operator==(const KeptConstraint&, const KeptConstraint&) = default;
};

/// The first rule that `constraints` break, naming the kind; nullopt if none.
[[nodiscard]] Refusal find_problem(const std::vector<KeptConstraint>& constraints);

/// Planarity to `tolerance` (mm/m) and `constraints`, which break no rule.
[[nodiscard]] KeptKinds kept_kinds(double tolerance,
                                   const std::vector<KeptConstraint>& constraints);

}  // namespace planish
