// SPDX-License-Identifier: MIT
/// Validation, once, at the door: after it a Mesh can be trusted everywhere.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish {

/// How the file names its elements: by the lines, from 1, on which a reader found them (empty where
/// a format has no lines), and by their numbers.
struct SourceLines {
  std::vector<int> vertices;  ///< one a vertex, or empty
  std::vector<int> faces;     ///< one a face, or empty
  int first = 0;              ///< the number of the first vertex and of the first face, 0 or 1
  /// One a face where some were left out, or empty: then they count on from `first`.
  std::vector<int> face_numbers = {};

  [[nodiscard]] int number_of_face(int f) const {
    return face_numbers.empty() ? f + first : face_numbers[static_cast<std::size_t>(f)];
  }
};

/// Accepts or refuses a mesh as read, in O(n log n). A refusal counts vertices and faces as the
/// file does; warnings are of a mesh that is open and count from 0 as everything else does then.
///
/// Refused, naming face or vertex and its line: non-finite or huge (> 1e100) coordinates, indices
/// out of range, no faces, faces under 3 vertices, a vertex repeated in a face, edges shared by
/// more than two faces, a mesh whose edges all have length zero.
/// Accepted with a warning that says what is done: inconsistent orientation, a surface with one
/// side (Möbius), vertices that join faces without a common edge, isolated vertices, zero-area
/// faces, coincident vertices. Vertex and face order never change.
[[nodiscard]] ReadResult check_mesh(Mesh mesh, const SourceLines& lines = {});

/// The warning of panels whose neighbours face the other way; nullopt where all agree. O(n log n).
/// @param mesh must have passed check_mesh()
[[nodiscard]] std::optional<std::string> orientation_warning(const Mesh& mesh);

/// Figures for `planish info` and the import report.
struct MeshSummary {
  int vertices = 0, faces = 0;
  std::map<int, int> face_sizes;  ///< size → count
  int boundary_loops = 0;         ///< a hole that meets another at a vertex counts on its own
  int components = 0;             ///< pieces joined by common vertices; isolated vertices left out
  int nonmanifold_edges = 0;      ///< shared by more than two faces; 0 after check_mesh()
  int isolated_vertices = 0;      ///< used by no face
  int pinch_vertices = 0;         ///< whose faces do not form one fan or disk
  double mean_edge = 0.0;         ///< model units
};

/// @param mesh indices must be in range; it need not pass check_mesh() otherwise
[[nodiscard]] MeshSummary summarize(const Mesh& mesh);

}  // namespace planish
