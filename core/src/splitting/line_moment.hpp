// SPDX-License-Identifier: MIT
/// How much a line through a panel would let go.
#pragma once

#include <span>

#include "planish/cuts/cut.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/problem/corner_force.hpp"

namespace planish {

/// |Σ e · ((x_v − x_a) × f_v)| over the corners on one side of a line from a to b, e its direction:
/// by how much the objective falls per radian that the panel may fold along it. [SPL-4]
/// @param cut between two corners of a panel of `mesh`
/// @param shape 3 × vertices of `mesh`, where `forces` are
[[nodiscard]] double moment_across(const Mesh& mesh, const Positions& shape,
                                   std::span<const CornerForce> forces, const SplitCut& cut);

}  // namespace planish
