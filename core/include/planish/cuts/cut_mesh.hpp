// SPDX-License-Identifier: MIT
/// A mesh after cuts: panels are parted or go, points are added on edges or inside panels, and none
/// moves. [CUT-1]
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "planish/cuts/cut.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// A point that a cut added, and where it stands in the mesh that was given: on the side between
/// two points, or inside a panel.
struct AddedPoint {
  int vertex = 0;
  int from = -1, to = -1;  ///< ends of the side, from < to; -1, -1 where it stands inside `panel`
  int panel = -1;          ///< -1 where it stands on a side
};

/// What one cut left behind, by the numbers of the finished mesh.
struct CutRecord {
  Cut cut;
  std::vector<int> panels;    ///< the parts that it made
  std::vector<int> points;    ///< those that it added
  std::vector<int> straight;  ///< panels that it gave straight corners and nothing else
};

/// Points of the mesh that was given keep numbers and bits; the added ones follow. Panels that were
/// not cut keep their corners, the first part of one that was keeps its number, and the other parts
/// follow behind all panels; where a trim takes panels away the numbers close up. Groups keep their
/// panels.
struct CutMesh {
  Mesh mesh;
  std::vector<int> parents;        ///< one a panel: which of the mesh that was given
  std::vector<AddedPoint> added;   ///< one a new point
  std::vector<CutRecord> records;  ///< one a cut
};

/// `mesh` after `cuts` in their order, each about the mesh that the one before it left; or one
/// sentence that names the cut and why it cannot be made. O(n) and the size of what is cut.
/// @param mesh must have passed check_mesh()
[[nodiscard]] std::variant<CutMesh, std::string> cut_mesh(const Mesh& mesh,
                                                          const std::vector<Cut>& cuts);

}  // namespace planish
