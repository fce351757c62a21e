// SPDX-License-Identifier: MIT
/// What is measured on a mesh: planarity, movement, degrees of freedom.
#pragma once

#include "planish/constraints/planar_polygon.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

struct PlanaritySummary {
  double max = 0.0, mean = 0.0;  ///< mm/m over faces with more than three vertices
  double max_gap = 0.0;          ///< model units, of any face: not always of worst_face
  double max_excess = 0.0;       ///< mm/m: the mesh is flat where this is within the tolerance
  int worst_face = -1;           ///< the face that max is of; -1 if there are only triangles
  double worst_gap = 0.0;        ///< gap of worst_face, model units
};

[[nodiscard]] PlanaritySummary planarity_summary(const Mesh& mesh);
[[nodiscard]] PlanaritySummary planarity_summary(const Mesh& mesh, const Positions& positions);

/// d = 3 N_V − Σ (i − 3) F_i (Sec. 2.1); vertices that no face uses are left out. [MET-2]
[[nodiscard]] int degrees_of_freedom(const Mesh& mesh);

/// Vertices whose coordinates are not bit-identical, ascending; 0 and −0 differ.
[[nodiscard]] std::vector<int> moved_vertices(const Positions& before, const Positions& after);
/// How many they are.
[[nodiscard]] int moved_vertex_count(const Positions& before, const Positions& after);

}  // namespace planish
