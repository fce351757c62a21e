// SPDX-License-Identifier: MIT
/// What the objective of an edit asks of each vertex.
#pragma once

#include <vector>

#include "planish/handle_edit.hpp"
#include "planish/problem.hpp"

namespace planish {

/// Writes the terms of (3) into a problem: handles are drawn to their targets, pins are fixed, the
/// rest stays where it is by ω_s. Remembers which terms are not the default, so that new targets
/// cost what they and the last ones have, not the mesh.
class EditTerms {
 public:
  /// Every vertex its default. `problem.model` is set.
  void fill(const HandleEditOptions& options, EditProblem& problem);

  /// The handles and pins of `targets` and no others; `problem.handles` ascending.
  void assign(const EditTargets& targets, const HandleEditOptions& options, EditProblem& problem);

 private:
  std::vector<int> overridden_;  ///< vertices whose term is not the default
};

}  // namespace planish
