// SPDX-License-Identifier: MIT
/// Where a plane cuts the structure: exact polylines from edge to edge.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planish/fabrication/joints.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// The points p with normal · p = offset.
struct SectionPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< unit; a section is seen against it
  double offset = 0.0;                                ///< the mesh's unit
};

/// One connected piece of a section.
struct SectionLine {
  Positions points;         ///< 3 × n, each on an edge of the mesh; consecutive ones differ
  std::vector<int> panels;  ///< that hold each stretch: n of a closed line, n − 1 of an open one
  bool closed = false;      ///< the last point is joined to the first
};

/// The section of `mesh` by `plane`. A corner in the plane counts as above it, so that a panel
/// in the plane gives nothing of its own, and an edge in it is drawn where a panel below ends
/// there. Lines end at the boundary and where more than two panels share an edge. O(n log n).
/// @param mesh must have passed check_mesh(); @param joints of it
[[nodiscard]] std::vector<SectionLine> cut_by(const Mesh& mesh, const JointTable& joints,
                                              const SectionPlane& plane);

}  // namespace planish
