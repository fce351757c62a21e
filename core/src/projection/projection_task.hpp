// SPDX-License-Identifier: MIT
/// What one projection is about, and what its attempts have in common.
#pragma once

#include <vector>

#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/problem/mesh_standing.hpp"
#include "planish/problem/problem.hpp"
#include "planish/projection/projection.hpp"

namespace planish {

/// One projection: what was given, and how flat it was.
struct ProjectionTask {
  const Mesh& mesh;
  const Mesh& base;            ///< of the history, or `mesh`: what supports are about
  const Positions* reference;  ///< null without a history
  const ProjectionOptions& options;
  const std::vector<int>& pins;
  const KeptKinds& kept;
  const Adjacency& adjacency;  ///< empty unless a kept kind hangs on stars
  MeshStanding before;
};

/// What moved from `before` to `after`, and how far: both 3 × n.
void record_moves(const Positions& before, const Positions& after, ProjectionResult& result);

/// How far the kept kinds are from holding, before and after.
void add_violations(const KeptKinds& kept, const Violations& before, const Violations& after,
                    SolveReport& report);

/// What a projection came to; `positions` are 3 × n.
void conclude(const ProjectionTask& task, const Positions& positions, MeshStanding after,
              ProjectionResult& result);

/// What was solved in place of (8) is not its solution, whatever its own engine says.
void say_if_confined(ProjectionResult& result);

/// Whether no panel lost its shape or was tipped over.
[[nodiscard]] bool is_sound(const ProjectionTask& task, const Positions& after);

/// The vertices within `rings` face rings of the failing panels, ascending, pins left out.
[[nodiscard]] std::vector<int> surroundings(const ProjectionTask& task, const MeshModel& model,
                                            int rings);

}  // namespace planish
