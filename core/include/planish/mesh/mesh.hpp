// SPDX-License-Identifier: MIT
/// A polygon mesh with any face sizes: the value that everything starts from.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace planish {

/// 3 × n, one point a column.
using Positions = Eigen::Matrix3Xd;

/// Squares and products of four coordinates must stay finite.
inline constexpr double kLargestCoordinate = 1e100;

/// A named run of faces, kept from file to file: starts at `first_face`, ends where the next
/// begins.
struct FaceGroup {
  std::string name;
  int first_face = 0;
  bool one_name = false;  ///< blanks belong to it; else they part the names of several groups
};

/// Vertices and faces in file order; immutable by convention once it has passed check_mesh().
struct Mesh {
  Positions positions;               ///< 3 × n_vertices, model units
  std::vector<int> face_offsets{0};  ///< n_faces + 1; face f owns [offsets[f], offsets[f + 1])
  std::vector<int> face_vertices;    ///< vertex indices from 0, in order around each face
  std::vector<FaceGroup> groups;     ///< sorted by first_face; may be empty

  [[nodiscard]] int vertex_count() const { return static_cast<int>(positions.cols()); }
  [[nodiscard]] int face_count() const { return static_cast<int>(face_offsets.size()) - 1; }

  /// The vertices of face `f`, in order.
  [[nodiscard]] std::span<const int> face(int f) const {
    const auto begin = static_cast<std::size_t>(face_offsets[static_cast<std::size_t>(f)]);
    const auto end = static_cast<std::size_t>(face_offsets[static_cast<std::size_t>(f) + 1]);
    return std::span<const int>(face_vertices).subspan(begin, end - begin);
  }
};

/// Mean length over the distinct edges of the faces, model units; 0 for a mesh without faces.
[[nodiscard]] double mean_edge_length(const Mesh& mesh);

}  // namespace planish
