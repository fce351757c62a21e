// SPDX-License-Identifier: MIT
/// The edges of a mesh, each once, with where they point.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

struct DirectedEdge {
  int from = 0, to = 0;  ///< from < to
  /// Unit; zero where the ends coincide, which then stay together.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();

  /// The part of `vector` that is not along the edge.
  [[nodiscard]] Eigen::Vector3d across(const Eigen::Vector3d& vector) const {
    return vector - direction * direction.dot(vector);
  }
};

/// Ascending by their ends. Edges shorter than 1e-9 of the mean edge count as points.
[[nodiscard]] std::vector<DirectedEdge> directed_edges(const Mesh& mesh);

}  // namespace planish
