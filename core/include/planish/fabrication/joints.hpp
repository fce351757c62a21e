// SPDX-License-Identifier: MIT
/// Where panels meet: every edge once, with the angle between its two panels.
#pragma once

#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// One side of one panel; `panel` < 0: there is none.
struct PanelSide {
  int panel = -1, side = -1;  ///< side k runs from corner k of the panel to the next
};

/// One edge. A boundary edge has no second panel.
struct Joint {
  int from = 0, to = 0;     ///< vertices, the way that the first panel runs
  PanelSide first, second;  ///< the first is the panel with the lower index
  bool same_way = false;    ///< both panels run from `from` to `to`: they are not oriented alike
  double length = 0.0;      ///< model units
  /// Angle of the material on the inside between the two panels, radians, 0 … 2π: π is flat, less
  /// is a ridge seen from outside, more a valley. Measured about the edge, between panel_normal()
  /// of both; outside is that of the first panel. π on the boundary. [FAB-1]
  double dihedral = 0.0;
};

/// All edges of a mesh that has passed check_mesh(), in the order in which the faces, side by side,
/// first use them; and for each side of each face its joint, laid out as Mesh::face_vertices.
struct JointTable {
  std::vector<Joint> joints;
  std::vector<int> of_side;
};

[[nodiscard]] JointTable joint_table(const Mesh& mesh);

/// Joint::dihedral of the panels with the unit normals `first` and `second` about `edge`. [FAB-1]
/// @param edge as the first panel runs, any length; @param second turned to the first panel's side
[[nodiscard]] double dihedral(const Eigen::Vector3d& edge, const Eigen::Vector3d& first,
                              const Eigen::Vector3d& second);

}  // namespace planish
