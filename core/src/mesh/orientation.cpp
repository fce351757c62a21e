// SPDX-License-Identifier: MIT
#include "planish/mesh/orientation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mesh/edge_table.hpp"
#include "planish/mesh/area_vector.hpp"

namespace planish {
namespace {

/// What hangs together over edges, and how it faces as its first panel does.
struct Part {
  bool one_sided = false, closed = true;
  double volume = 0.0;    ///< six times, about the part's first corner
  double upward = 0.0;    ///< the area vectors' sum along z
  double area = 0.0;      ///< of all panels
  double as_given = 0.0;  ///< of those that face as they did, less that of the others
};

/// A panel on the other side of an edge.
struct Neighbour {
  int face = 0;
  bool clash = false;  ///< whether both run along the edge the same way
};

/// The neighbours of each face, and how many of its edges have none.
struct FaceNeighbours {
  std::vector<std::vector<Neighbour>> of;
  std::vector<int> open_edges;
};

FaceNeighbours neighbours_of(const Mesh& mesh) {
  const auto count = static_cast<std::size_t>(mesh.face_count());
  FaceNeighbours neighbours{std::vector<std::vector<Neighbour>>(count), std::vector<int>(count, 0)};
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for (const auto edge : by_edge(uses)) {
    const auto first = static_cast<std::size_t>(edge[0].face);
    if (edge.size() != 2) {
      ++neighbours.open_edges[first];
      continue;
    }
    const bool clash = edge[0].forward == edge[1].forward;
    neighbours.of[first].push_back({edge[1].face, clash});
    neighbours.of[static_cast<std::size_t>(edge[1].face)].push_back({edge[0].face, clash});
  }
  return neighbours;
}

/// Adds a face, turned or not, to what is known of its part.
void add_face(const Mesh& mesh, int f, bool turned, const Eigen::Vector3d& origin, Part& part) {
  const Eigen::Vector3d area = area_vector(mesh.positions, mesh.face(f));
  const double sign = turned ? -1.0 : 1.0;
  const Eigen::Vector3d arm = mesh.positions.col(mesh.face(f)[0]) - origin;
  part.volume += sign * arm.dot(area);
  part.upward += sign * area.z();
  part.area += area.norm();
  part.as_given += sign * area.norm();
}

/// Whether all panels of the part must be turned once more.
bool faces_wrong_way(const Part& part) {
  constexpr double kLevel = 1e-6;  // of the area: below that rounding would decide
  if (part.closed && part.volume != 0) return part.volume < 0;
  if (std::abs(part.upward) > kLevel * part.area) return part.upward < 0;
  return part.as_given < 0;
}

/// Walks over the part of `first`, and marks which of its faces are turned; the part's faces.
std::vector<int> mark_part(const Mesh& mesh, int first, const FaceNeighbours& neighbours,
                           std::vector<signed char>& marks, Part& part) {
  const Eigen::Vector3d origin = mesh.positions.col(mesh.face(first)[0]);
  std::vector<int> faces = {first};
  marks[static_cast<std::size_t>(first)] = 0;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const auto f = static_cast<std::size_t>(faces[k]);
    add_face(mesh, faces[k], marks[f] == 1, origin, part);
    if (neighbours.open_edges[f] > 0) part.closed = false;
    for (const Neighbour& next : neighbours.of[f]) {
      signed char& mark = marks[static_cast<std::size_t>(next.face)];
      const auto wanted = static_cast<signed char>((marks[f] == 1) != next.clash ? 1 : 0);
      if (mark < 0) {
        mark = wanted;
        faces.push_back(next.face);
      } else if (mark != wanted) {
        part.one_sided = true;
      }
    }
  }
  return faces;
}

}  // namespace

Oriented oriented(Mesh mesh) {
  const FaceNeighbours neighbours = neighbours_of(mesh);
  std::vector<signed char> marks(static_cast<std::size_t>(mesh.face_count()), -1);
  Oriented result;
  for (int first = 0; first < mesh.face_count(); ++first) {
    if (marks[static_cast<std::size_t>(first)] >= 0) continue;
    Part part;
    const std::vector<int> faces = mark_part(mesh, first, neighbours, marks, part);
    if (part.one_sided) continue;
    const bool all = faces_wrong_way(part);
    for (const int f : faces) {
      if ((marks[static_cast<std::size_t>(f)] == 1) == all) continue;
      const auto begin = mesh.face_vertices.begin();
      std::reverse(begin + mesh.face_offsets[static_cast<std::size_t>(f)] + 1,
                   begin + mesh.face_offsets[static_cast<std::size_t>(f) + 1]);
      ++result.turned;
    }
  }
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace planish
