// SPDX-License-Identifier: MIT
/// What is measured on a mesh: planarity, movement, degrees of freedom.
#pragma once

#include <span>

#include "planish/mesh.hpp"

namespace planish {

/// Flatness of one panel.
struct FacePlanarity {
  double gap = 0.0;       ///< max − min signed distance to the best-fit plane, model units
  double mm_per_m = 0.0;  ///< 1000 · gap / longest edge; 0 for triangles [MET-1]
  /// mm_per_m, or 0 where the rounding of the panel's own coordinates accounts for it: a panel of
  /// 1 m at 1e7 m cannot be flatter than about 1e-6 mm/m, wherever its corners go. Rounding never
  /// accounts for more than 1e-3 mm/m. What is compared with a tolerance. [MET-3]
  double excess = 0.0;
};

/// [MET-1] for one face; `positions` is 3 × n of the whole mesh.
[[nodiscard]] FacePlanarity face_planarity(const Positions& positions, std::span<const int> face);

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

/// Vertices whose coordinates are not bit-identical.
[[nodiscard]] int moved_vertex_count(const Positions& before, const Positions& after);

}  // namespace planish
