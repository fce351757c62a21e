// SPDX-License-Identifier: MIT
/// With what force a panel stays flat.
#pragma once

#include <Eigen/Core>

namespace planish {

/// What a panel does to one of its corners so that it stays flat: λ ∇c of its rows, which sum to
/// nought over its corners. Forces are in the unit of the objective over mean edges.
struct CornerForce {
  int panel = 0, vertex = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
};

}  // namespace planish
