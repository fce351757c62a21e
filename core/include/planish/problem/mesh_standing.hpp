// SPDX-License-Identifier: MIT
/// How far a mesh is from its constraints, and where.
#pragma once

#include <vector>

#include "planish/constraints/elements.hpp"
#include "planish/constraints/kept_kinds.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/problem/solve_report.hpp"

namespace planish {

struct MeshStanding {
  Violations worst;
  /// Faces that break a constraint or have a point that does, worst first.
  std::vector<int> failing;
};

/// @param adjacency of `mesh`; may be empty where no kept kind hangs on stars
[[nodiscard]] MeshStanding measure_standing(const Mesh& mesh, const Adjacency& adjacency,
                                            const KeptKinds& kept);

/// What a report says of the kept kinds, name by name, planarity first.
[[nodiscard]] std::vector<KindViolation> kind_violations(const KeptKinds& kept,
                                                         const Violations& before,
                                                         const Violations& after);

/// The corners of `faces`, ascending, no duplicates.
[[nodiscard]] std::vector<int> vertices_of(const Mesh& mesh, const std::vector<int>& faces);

}  // namespace planish
