// SPDX-License-Identifier: MIT
#include "planish/mesh/adjacency.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace planish {
namespace {

/// Where a face meets a vertex: the face's vertices before and after it.
struct Corner {
  int before, after;
};

/// Where each vertex is used: faces in ascending order, and its place in `face_vertices` for each.
struct VertexUses {
  RaggedRows faces;
  std::vector<int> places;
};

/// The faces of each vertex and its places in them, by counting sort.
VertexUses uses_of_vertices(const Mesh& mesh) {
  VertexUses uses;
  RaggedRows& rows = uses.faces;
  rows.offsets.assign(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
  for (const int v : mesh.face_vertices) ++rows.offsets[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 1; v < rows.offsets.size(); ++v) rows.offsets[v] += rows.offsets[v - 1];
  rows.values.resize(mesh.face_vertices.size());
  uses.places.resize(mesh.face_vertices.size());
  std::vector<int> next(rows.offsets.begin(), rows.offsets.end() - 1);
  int place = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const int v : mesh.face(f)) {
      const auto at = static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++);
      rows.values[at] = f;
      uses.places[at] = place++;
    }
  }
  return uses;
}

Corner corner_at(const Mesh& mesh, int f, int place) {
  const auto face = mesh.face(f);
  const auto at = static_cast<std::size_t>(place - mesh.face_offsets[static_cast<std::size_t>(f)]);
  return {face[at > 0 ? at - 1 : face.size() - 1], face[at + 1 < face.size() ? at + 1 : 0]};
}

/// Walks around one vertex. Each corner joins two neighbours; a walk that starts at a neighbour
/// used by one corner only (a boundary edge) visits a fan, any other walk a disk. In O(n log n): a
/// vertex may be the tip of a cone of any number of faces.
class VertexFan {
 public:
  void start() {
    corners_.clear();
    uses_.clear();
  }
  void add(Corner corner) {
    const auto index = corners_.size();
    uses_.push_back({corner.before, index});
    uses_.push_back({corner.after, index});
    corners_.push_back(corner);
  }

  /// Neighbours in order, appended to `out`. Returns {on a boundary, a single fan or disk}.
  std::pair<bool, bool> append_ordered(std::vector<int>& out) {
    std::sort(uses_.begin(), uses_.end());
    used_.assign(corners_.size(), 0);
    bool boundary = false;
    int walks = 0;
    for (std::size_t c = 0; c < corners_.size(); ++c) {  // fans first: they have ends to start from
      for (const int neighbour : {corners_[c].before, corners_[c].after}) {
        if (used_[c] || uses_of(neighbour).size() != 1) continue;
        boundary = true;
        ++walks;
        walk(neighbour, out);
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
  using Use = std::pair<int, std::size_t>;  ///< a neighbour and a corner that it belongs to

  [[nodiscard]] std::span<const Use> uses_of(int neighbour) const {
    const auto begin = std::lower_bound(uses_.begin(), uses_.end(), Use{neighbour, 0});
    auto end = begin;
    while (end != uses_.end() && end->first == neighbour) ++end;
    return std::span<const Use>(uses_).subspan(static_cast<std::size_t>(begin - uses_.begin()),
                                               static_cast<std::size_t>(end - begin));
  }

  void walk(int neighbour, std::vector<int>& out) {
    out.push_back(neighbour);
    for (bool moved = true; moved;) {
      moved = false;
      for (const auto& [from, c] : uses_of(neighbour)) {
        if (used_[c]) continue;
        neighbour = corners_[c].before == from ? corners_[c].after : corners_[c].before;
        used_[c] = 1;
        out.push_back(neighbour);
        moved = true;
        break;
      }
    }
  }

  std::vector<Corner> corners_;
  std::vector<Use> uses_;  ///< sorted
  std::vector<char> used_;
};

}  // namespace

Adjacency build_adjacency(const Mesh& mesh) {
  Adjacency adjacency;
  VertexUses uses = uses_of_vertices(mesh);
  adjacency.faces = std::move(uses.faces);
  const auto n = static_cast<std::size_t>(mesh.vertex_count());
  adjacency.boundary.assign(n, 0);
  adjacency.regular.assign(n, 1);
  adjacency.neighbours.offsets.reserve(n + 1);
  adjacency.neighbours.values.reserve(mesh.face_vertices.size() + n);
  VertexFan fan;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    fan.start();
    auto use = static_cast<std::size_t>(adjacency.faces.offsets[static_cast<std::size_t>(v)]);
    for (const int f : adjacency.faces[v]) fan.add(corner_at(mesh, f, uses.places[use++]));
    const auto [boundary, regular] = fan.append_ordered(adjacency.neighbours.values);
    adjacency.boundary[static_cast<std::size_t>(v)] = boundary ? 1 : 0;
    adjacency.regular[static_cast<std::size_t>(v)] = regular ? 1 : 0;
    adjacency.neighbours.offsets.push_back(static_cast<int>(adjacency.neighbours.values.size()));
  }
  return adjacency;
}

std::vector<int> boundary_vertices(const Mesh& mesh) {
  const Adjacency adjacency = build_adjacency(mesh);
  std::vector<int> vertices;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (adjacency.boundary[static_cast<std::size_t>(v)] != 0) vertices.push_back(v);
  }
  return vertices;
}

}  // namespace planish
