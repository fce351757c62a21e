// SPDX-License-Identifier: MIT
/// Who is next to whom: built once per mesh, in O(n).
#pragma once

#include <span>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

/// Rows of different lengths, stored one after the other.
struct RaggedRows {
  std::vector<int> offsets{0};
  std::vector<int> values;
  [[nodiscard]] int size() const { return static_cast<int>(offsets.size()) - 1; }
  [[nodiscard]] std::span<const int> operator[](int row) const {
    const auto begin = static_cast<std::size_t>(offsets[static_cast<std::size_t>(row)]);
    const auto end = static_cast<std::size_t>(offsets[static_cast<std::size_t>(row) + 1]);
    return std::span<const int>(values).subspan(begin, end - begin);
  }
  friend bool operator==(const RaggedRows&, const RaggedRows&) = default;
};

/// Vertex neighbourhoods. `neighbours[v]` goes around v in order, crossing one face a step; a
/// boundary vertex starts and ends at a boundary edge. Orientation of the faces does not matter.
struct Adjacency {
  RaggedRows neighbours;       ///< by edges, in order around the vertex
  RaggedRows faces;            ///< faces that use the vertex
  std::vector<char> boundary;  ///< 1 where the vertex lies on a boundary edge
  std::vector<char> regular;   ///< 1 where the faces around the vertex form one fan or one disk
};

[[nodiscard]] Adjacency build_adjacency(const Mesh& mesh);

/// Vertices on boundary edges, ascending.
[[nodiscard]] std::vector<int> boundary_vertices(const Mesh& mesh);

}  // namespace planish
