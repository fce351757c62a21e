// SPDX-License-Identifier: MIT
/// What an edit leaves free, and which panels hold a point back: rank and forces of the
/// constraints' equations at the points that move.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "planish/constraints/kept_kinds.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// A point and the way that is left to its target.
struct Pull {
  int vertex = 0;
  Eigen::Vector3d rest = Eigen::Vector3d::Zero();  ///< target − position, model units
};

/// A panel and how hard it holds back, as a share of the pull; levers make it exceed 1.
struct HoldingPanel {
  int face = 0;
  double share = 0.0;
};

/// Everything else is taken to stay where it is.
struct EditFreedom {
  int points = 0;     ///< that may move
  int equations = 0;  ///< of the kept kinds, with at least one of them
  int rank = 0;       ///< numerical rank of the equations' Jacobian at these points [FR-1]
  /// Share of the pull that the panels bear; what is left would still lead nearer. 0 … 1 [FR-2]
  double borne = 0.0;
  std::vector<HoldingPanel> holding;  ///< largest share first; those without one are left out

  /// Directions in which the points can move together with every constraint kept, to first order.
  [[nodiscard]] int freedom() const { return 3 * points - rank; }
};

/// @param positions 3 × n of the whole mesh, flat
/// @param kept the kinds whose equations count
/// @param free ascending vertices; those of `pulls` that are not among them count as held
/// @return nullopt where a dense factorization would be too large (some 500 points)
[[nodiscard]] std::optional<EditFreedom> measure_freedom(
    const Mesh& mesh, const Adjacency& adjacency, const Positions& positions,
    std::span<const int> free, std::span<const Pull> pulls, const KeptKinds& kept = KeptKinds());

}  // namespace planish
