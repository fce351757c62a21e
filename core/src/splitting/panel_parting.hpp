// SPDX-License-Identifier: MIT
/// How single panels part where a mesh is to become flat, and which of them first.
#pragma once

#include <span>
#include <vector>

#include "planish/cuts/cut.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

enum class Parting {
  kInTwo,        ///< quads along the shorter diagonal, larger panels in half
  kInTriangles,  ///< quads likewise, larger panels again and again
};

/// Cuts that part `panels`, in this order; a panel that no line parts is passed over.
[[nodiscard]] std::vector<Cut> parting_cuts(const Mesh& mesh, const Adjacency& adjacency,
                                            std::span<const int> panels, Parting parting);

/// Panels with more than three corners: `first` in their order, then those that share no side with
/// one before them, then the others; the more bent before the less.
[[nodiscard]] std::vector<int> parting_order(const Mesh& mesh, const Adjacency& adjacency,
                                             std::span<const int> first);

}  // namespace planish
