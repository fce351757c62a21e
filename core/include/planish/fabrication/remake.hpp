// SPDX-License-Identifier: MIT
/// What must be made again after an edit: certain, as what an edit does not touch is bit-identical.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// What became of a panel since the base; panels are compared by their number. A straight corner
/// that a cut put on its side changes nothing: one more node is there.
enum class PanelChange {
  kUnchanged,  ///< every corner bit-identical, every joint as it was
  kOutline,    ///< a corner moved: to be cut again
  kBevel,      ///< the same outline, but the angle to a neighbour changed, or which sides have one
  kNew,        ///< the base has no such panel, or one with another number of corners
};

/// What became of a node since the base; nodes are compared by their vertex.
enum class NodeChange {
  kUnchanged,
  kMoved,  ///< its position changed
  kArms,   ///< the same position, but its axis, an arm or a panel around it turned
  kNew,    ///< the base has no such vertex, or one with other arms or panels between
};

/// Angles that differ by less are the same, radians: ten times what a flat panel's own tolerance
/// (1e-6 mm/m) can turn it, 0.01 µm over a metre.
inline constexpr double kSameAngle = 1e-8;

struct Remake {
  std::vector<PanelChange> panels;  ///< one a face
  std::vector<NodeChange> nodes;    ///< one a vertex; kUnchanged for one without panels

  [[nodiscard]] int count(PanelChange change) const;
  [[nodiscard]] int count(NodeChange change) const;
};

/// Compares `mesh` with `base`, which may have other faces; both must have passed check_mesh().
/// O(n log n). [FAB-2, FAB-3]
[[nodiscard]] Remake find_remake(const Mesh& base, const Mesh& mesh);

/// What find_remake() says of the panels of `base` with `moved` (ascending) vertices at `positions`
/// (3 × n), at the cost of the panels around them. [FAB-2]
[[nodiscard]] std::vector<PanelChange> panels_to_remake(const Mesh& base,
                                                        const Adjacency& adjacency,
                                                        const Positions& positions,
                                                        std::span<const int> moved);

/// What find_remake() says of the nodes, likewise. [FAB-3]
[[nodiscard]] std::vector<NodeChange> nodes_to_remake(const Mesh& base, const Adjacency& adjacency,
                                                      const Positions& positions,
                                                      std::span<const int> moved);

/// `unchanged`, `outline`, `bevel` or `new`.
[[nodiscard]] std::string_view change_name(PanelChange change);
/// `unchanged`, `moved`, `arms` or `new`.
[[nodiscard]] std::string_view change_name(NodeChange change);

}  // namespace planish
