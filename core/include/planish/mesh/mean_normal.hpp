// SPDX-License-Identifier: MIT
/// Which way the panels around a point face on average: a drag follows it, and what goes across it
/// slides.
#pragma once

#include <Eigen/Core>
#include <span>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// The direction of the area vectors of `faces`, added up; of length 1, 0 where they cancel or
/// there are none. `positions` is 3 × n of the whole mesh.
[[nodiscard]] Eigen::Vector3d mean_normal(const Mesh& mesh, const Positions& positions,
                                          std::span<const int> faces);

/// What is left of `move` across `normal`, a unit vector or 0.
[[nodiscard]] inline Eigen::Vector3d across(const Eigen::Vector3d& move,
                                            const Eigen::Vector3d& normal) {
  return move - normal.dot(move) * normal;
}

}  // namespace planish
