// SPDX-License-Identifier: MIT
/// The methods that the paper argues against or builds on, each on the same EditTask, and the
/// paper's own algorithm as printed. docs/paper.md says what was simplified.
#pragma once

#include "planish/comparison/edit_task.hpp"

namespace planish::comparison {

/// [Hof10] as the paper describes it: the handle is put on its target, the other vertices of its
/// faces find flat positions by the shortest Newton steps, and nothing else moves.
[[nodiscard]] ComparedEdit edit_one_ring(const EditTask& task);

/// [HK12]: the fewest vertices that satisfy the linearised constraints, found greedily (orthogonal
/// matching pursuit over vertices), then reprojected onto the true constraints on that set.
[[nodiscard]] ComparedEdit edit_greedily(const EditTask& task);

/// [BDS*12], Shape-Up: local projections and a global least-squares step, planarity a soft term
/// with the weight of the handles, ω_f ‖E d‖² for smoothness; the boundary is held, since nothing
/// else keeps the mesh in place.
[[nodiscard]] ComparedEdit edit_by_shape_up(const EditTask& task);

/// [YYPM11]: the fairest displacement in the tangent space that follows the handles, no sparsity,
/// the boundary held; then reprojected onto the constraints by Newton steps.
[[nodiscard]] ComparedEdit edit_in_tangent_space(const EditTask& task);

/// Sec. 3 as printed, on the whole mesh, with `inner_limit` steps of alternating minimisation per
/// dual update (l_max; 1 is plain ADMM) and `step_budget` of them in all. No exact finish.
[[nodiscard]] ComparedEdit edit_by_alternation(const EditTask& task, int inner_limit,
                                               int step_budget);

}  // namespace planish::comparison
