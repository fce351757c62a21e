// SPDX-License-Identifier: MIT
/// Validation, once, at the door: after it a Mesh can be trusted everywhere.
#pragma once

#include <map>
#include <string>
#include <variant>

#include "planish/io/read_result.hpp"
#include "planish/mesh.hpp"

namespace planish {

/// Accepts or refuses a mesh as read. Refused, naming face or vertex: non-finite coordinates,
/// indices out of range, no faces, faces under 3 vertices, a vertex repeated in a face,
/// edges shared by more than two faces. Accepted with a warning that says what is done:
/// inconsistent orientation, isolated vertices, zero-area faces, coincident vertices.
/// Vertex and face order never change.
[[nodiscard]] ReadResult check_mesh(Mesh mesh);

/// Figures for `planish info` and the import report.
struct MeshSummary {
  int vertices = 0, faces = 0;
  std::map<int, int> face_sizes;  ///< size → count
  int boundary_loops = 0, components = 0, nonmanifold_edges = 0, isolated_vertices = 0;
  double mean_edge = 0.0;  ///< model units
};

[[nodiscard]] MeshSummary summarize(const Mesh& mesh);

}  // namespace planish
