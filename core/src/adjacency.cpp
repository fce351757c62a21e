// SPDX-License-Identifier: MIT
#include "planish/adjacency.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace planish {
namespace {

/// Where a face meets a vertex: the face's vertices before and after it.
struct Corner {
  int before, after;
};

/// Faces of each vertex, by counting sort: ascending face index within a row.
RaggedRows faces_of_vertices(const Mesh& mesh) {
  RaggedRows rows;
  rows.offsets.assign(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
  for (const int v : mesh.face_vertices) ++rows.offsets[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 1; v < rows.offsets.size(); ++v) rows.offsets[v] += rows.offsets[v - 1];
  rows.values.resize(mesh.face_vertices.size());
  std::vector<int> next(rows.offsets.begin(), rows.offsets.end() - 1);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const int v : mesh.face(f)) {
      rows.values[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = f;
    }
  }
  return rows;
}

Corner corner_at(std::span<const int> face, int vertex) {
  const auto at = static_cast<std::size_t>(
      std::distance(face.begin(), std::find(face.begin(), face.end(), vertex)));
  return {face[(at + face.size() - 1) % face.size()], face[(at + 1) % face.size()]};
}

/// Walks around one vertex. Each corner joins two neighbours; a walk that starts at a neighbour
/// used by one corner only (a boundary edge) visits a fan, any other walk a disk.
class VertexFan {
 public:
  void start() { corners_.clear(); }
  void add(Corner corner) { corners_.push_back(corner); }

  /// Neighbours in order, appended to `out`. Returns {on a boundary, a single fan or disk}.
  std::pair<bool, bool> append_ordered(std::vector<int>& out) {
    used_.assign(corners_.size(), 0);
    bool boundary = false;
    int walks = 0;
    for (const Corner& corner : corners_) {  // fans first: they have ends to start from
      for (const int neighbour : {corner.before, corner.after}) {
        if (open_uses(neighbour) == 1 && total_uses(neighbour) == 1) {
          boundary = true;
          ++walks;
          walk(neighbour, out);
        }
      }
    }
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      if (used_[c]) continue;
      ++walks;
      walk(corners_[c].before, out);
      out.pop_back();  // a disk ends where it began
    }
    return {boundary, walks <= 1};
  }

 private:
  [[nodiscard]] int total_uses(int neighbour) const {
    return static_cast<int>(std::count_if(corners_.begin(), corners_.end(), [&](const Corner& c) {
      return c.before == neighbour || c.after == neighbour;
    }));
  }
  [[nodiscard]] int open_uses(int neighbour) const {
    int uses = 0;
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      if (!used_[c] && (corners_[c].before == neighbour || corners_[c].after == neighbour)) ++uses;
    }
    return uses;
  }
  void walk(int neighbour, std::vector<int>& out) {
    out.push_back(neighbour);
    for (bool moved = true; moved;) {
      moved = false;
      for (std::size_t c = 0; c < corners_.size() && !moved; ++c) {
        if (used_[c]) continue;
        if (corners_[c].before != neighbour && corners_[c].after != neighbour) continue;
        neighbour = corners_[c].before == neighbour ? corners_[c].after : corners_[c].before;
        used_[c] = 1;
        out.push_back(neighbour);
        moved = true;
      }
    }
  }

  std::vector<Corner> corners_;
  std::vector<char> used_;
};

}  // namespace

Adjacency build_adjacency(const Mesh& mesh) {
  Adjacency adjacency;
  adjacency.faces = faces_of_vertices(mesh);
  const auto n = static_cast<std::size_t>(mesh.vertex_count());
  adjacency.boundary.assign(n, 0);
  adjacency.regular.assign(n, 1);
  adjacency.neighbours.offsets.reserve(n + 1);
  adjacency.neighbours.values.reserve(mesh.face_vertices.size() + n);
  VertexFan fan;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    fan.start();
    for (const int f : adjacency.faces[v]) fan.add(corner_at(mesh.face(f), v));
    const auto [boundary, regular] = fan.append_ordered(adjacency.neighbours.values);
    adjacency.boundary[static_cast<std::size_t>(v)] = boundary ? 1 : 0;
    adjacency.regular[static_cast<std::size_t>(v)] = regular ? 1 : 0;
    adjacency.neighbours.offsets.push_back(static_cast<int>(adjacency.neighbours.values.size()));
  }
  return adjacency;
}

}  // namespace planish
