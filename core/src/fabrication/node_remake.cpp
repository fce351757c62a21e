// SPDX-License-Identifier: MIT
#include "fabrication/node_remake.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "fabrication/node_axis.hpp"
#include "planish/fabrication/panel_frame.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// A mesh before or after the edit; its points may stand elsewhere than in `mesh`.
struct Side {
  const Mesh& mesh;
  const Positions& positions;  ///< 3 × n
  const Adjacency& adjacency;
};

bool same_point(const Side& before, const Side& after, int vertex) {
  return std::memcmp(before.positions.col(vertex).data(), after.positions.col(vertex).data(),
                     3 * sizeof(double)) == 0;
}

bool same_direction(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a.stableNormalized() - b.stableNormalized()).norm() <= kSameAngle;
}

/// Whether the vertex has the same neighbours, in the same order.
bool same_neighbours(const Adjacency& before, const Adjacency& after, int vertex) {
  if (vertex >= before.neighbours.size()) return false;
  const auto was = before.neighbours[vertex];
  const auto is = after.neighbours[vertex];
  return std::equal(is.begin(), is.end(), was.begin(), was.end());
}

bool same_arms(const Side& before, const Side& after, int vertex) {
  const auto ends = after.adjacency.neighbours[vertex];
  return std::all_of(ends.begin(), ends.end(), [&](int end) {
    return same_direction(before.positions.col(end) - before.positions.col(vertex),
                          after.positions.col(end) - after.positions.col(vertex));
  });
}

bool same_planes(const Side& before, const Side& after, int vertex) {
  const auto faces = after.adjacency.faces[vertex];
  return std::all_of(faces.begin(), faces.end(), [&](int f) {
    return same_direction(panel_normal(before.positions, before.mesh.face(f)),
                          panel_normal(after.positions, after.mesh.face(f)));
  });
}

bool same_axis(const Side& before, const Side& after, int vertex) {
  return same_direction(node_axis(before.mesh, before.positions, before.adjacency, vertex),
                        node_axis(after.mesh, after.positions, after.adjacency, vertex));
}

/// The change of a node that has the same neighbours and panels on both sides.
NodeChange compare_node(const Side& before, const Side& after, int vertex) {
  if (!same_point(before, after, vertex)) return NodeChange::kMoved;
  const bool same = same_arms(before, after, vertex) && same_planes(before, after, vertex) &&
                    same_axis(before, after, vertex);
  return same ? NodeChange::kUnchanged : NodeChange::kArms;
}

/// Where each arm of a node ended before: there, or beyond a point that its side has since. Empty
/// where some arm is another.
std::vector<int> ends_before(const Side& before, const Side& after, int vertex) {
  const auto was = before.adjacency.neighbours[vertex];
  const auto is = after.adjacency.neighbours[vertex];
  std::vector<int> ends;
  for (const int end : is) {
    const auto found = std::find_if(was.begin(), was.end(), [&](int other) {
      if (other == end || end < before.mesh.vertex_count()) return other == end;
      return same_direction(before.positions.col(other) - before.positions.col(vertex),
                            after.positions.col(end) - after.positions.col(vertex));
    });
    if (found != was.end()) ends.push_back(*found);
  }
  std::vector<int> all = ends;
  std::sort(all.begin(), all.end());
  const bool twice = std::adjacent_find(all.begin(), all.end()) != all.end();
  if (twice || ends.size() != is.size() || ends.size() != was.size()) ends.clear();
  return ends;
}

/// The corners of face f before and behind `vertex`.
std::array<int, 2> corners_beside(const Side& side, int f, int vertex) {
  const auto face = side.mesh.face(f);
  const auto k =
      static_cast<std::size_t>(std::find(face.begin(), face.end(), vertex) - face.begin());
  return {face[(k + face.size() - 1) % face.size()], face[(k + 1) % face.size()]};
}

/// The change of a node whose panels or neighbours are others by number: parted panels, divided
/// sides.
NodeChange compare_renumbered(const Side& before, const Side& after, int vertex) {
  if (vertex >= before.mesh.vertex_count() || !same_point(before, after, vertex)) {
    return NodeChange::kNew;
  }
  const std::vector<int> ends = ends_before(before, after, vertex);
  const auto is = after.adjacency.neighbours[vertex];
  const auto was_faces = before.adjacency.faces[vertex];
  const auto is_faces = after.adjacency.faces[vertex];
  if (ends.empty() || was_faces.size() != is_faces.size()) return NodeChange::kNew;
  bool same = same_axis(before, after, vertex);
  for (const int f : is_faces) {
    std::array<int, 2> beside = corners_beside(after, f, vertex);
    for (int& end : beside)
      end = ends[at(static_cast<int>(std::find(is.begin(), is.end(), end) - is.begin()))];
    const auto found = std::find_if(was_faces.begin(), was_faces.end(), [&](int g) {
      return corners_beside(before, g, vertex) == beside;
    });
    if (found == was_faces.end()) return NodeChange::kNew;
    same = same && same_direction(panel_normal(before.positions, before.mesh.face(*found)),
                                  panel_normal(after.positions, after.mesh.face(f)));
  }
  return same ? NodeChange::kUnchanged : NodeChange::kArms;
}

}  // namespace

std::vector<NodeChange> compare_nodes(const Mesh& base, const Mesh& mesh,
                                      const std::vector<PanelChange>& panels) {
  const Adjacency before = build_adjacency(base);
  const Adjacency after = build_adjacency(mesh);
  std::vector<NodeChange> changes(at(mesh.vertex_count()), NodeChange::kUnchanged);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto faces = after.faces[v];
    if (faces.empty()) continue;
    const bool new_panel = std::any_of(faces.begin(), faces.end(),
                                       [&](int f) { return panels[at(f)] == PanelChange::kNew; });
    changes[at(v)] =
        new_panel || !same_neighbours(before, after, v)
            ? compare_renumbered({base, base.positions, before}, {mesh, mesh.positions, after}, v)
            : compare_node({base, base.positions, before}, {mesh, mesh.positions, after}, v);
  }
  return changes;
}

std::vector<NodeChange> nodes_to_remake(const Mesh& base, const Adjacency& adjacency,
                                        const Positions& positions, std::span<const int> moved) {
  std::vector<NodeChange> changes(at(base.vertex_count()), NodeChange::kUnchanged);
  std::vector<char> compared(at(base.vertex_count()), 0);
  for (const int v : moved) {
    for (const int f : adjacency.faces[v]) {
      for (const int corner : base.face(f)) {
        if (compared[at(corner)] != 0) continue;
        compared[at(corner)] = 1;
        changes[at(corner)] =
            compare_node({base, base.positions, adjacency}, {base, positions, adjacency}, corner);
      }
    }
  }
  return changes;
}

std::string_view change_name(NodeChange change) {
  switch (change) {
    case NodeChange::kUnchanged:
      return "unchanged";
    case NodeChange::kMoved:
      return "moved";
    case NodeChange::kArms:
      return "arms";
    case NodeChange::kNew:
      return "new";
  }
  return "unknown";
}

}  // namespace planish
