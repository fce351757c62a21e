// SPDX-License-Identifier: MIT
#include "io/polygon_fans.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/edge_table.hpp"
#include "numeric/disjoint_sets.hpp"

namespace planish {
namespace {

/// Twice the area vector of the triangle of three vertices.
Eigen::Vector3d area_vector(const Positions& positions, int a, int b, int c) {
  const Eigen::Vector3d origin = positions.col(a);
  const Eigen::Vector3d first = positions.col(b) - origin, second = positions.col(c) - origin;
  return first.cross(second);
}

/// Whether no triangle of the fan from corner `start` is turned over.
bool is_fan_upright(const Positions& positions, std::span<const int> face, std::size_t start,
                    const Eigen::Vector3d& normal) {
  const std::size_t n = face.size();
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const Eigen::Vector3d area =
        area_vector(positions, face[start], face[(start + k) % n], face[(start + k + 1) % n]);
    if (area.dot(normal) < 0) return false;
  }
  return true;
}

std::size_t fan_start(const Positions& positions, std::span<const int> face, int previous_start) {
  const std::size_t fallback = face[0] != previous_start ? 0 : 1;
  // Trying every corner costs the square of the face size; faces beyond this are not panels.
  constexpr std::size_t kLargestTried = 64;
  if (face.size() == 3 || face.size() > kLargestTried) return fallback;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t k = 1; k + 1 < face.size(); ++k) {
    normal += area_vector(positions, face[0], face[k], face[k + 1]);
  }
  for (std::size_t start = 0; start < face.size(); ++start) {
    if (face[start] == previous_start) continue;
    if (is_fan_upright(positions, face, start, normal)) return start;
  }
  return fallback;
}

/// Appends the face of the fan in `triangles`; false if they are none.
bool append_fan(std::span<const int> triangles, FaceList& faces) {
  faces.vertices.insert(faces.vertices.end(), triangles.begin(), triangles.begin() + 3);
  for (std::size_t at = 3; at < triangles.size(); at += 3) {
    if (triangles[at] != triangles[0] || triangles[at + 1] != faces.vertices.back()) return false;
    faces.vertices.push_back(triangles[at + 2]);
  }
  faces.offsets.push_back(static_cast<int>(faces.vertices.size()));
  return true;
}

Mesh triangle_mesh(const Positions& positions, std::span<const int> triangles) {
  Mesh mesh;
  mesh.positions = positions;
  mesh.face_vertices.assign(triangles.begin(), triangles.end());
  for (std::size_t end = 3; end <= triangles.size(); end += 3) {
    mesh.face_offsets.push_back(static_cast<int>(end));
  }
  return mesh;
}

bool are_coplanar(const Mesh& mesh, int f, int g) {
  constexpr double kTolerance = 1e-4;
  const auto a = mesh.face(f), b = mesh.face(g);
  const Eigen::Vector3d first = area_vector(mesh.positions, a[0], a[1], a[2]);
  const Eigen::Vector3d second = area_vector(mesh.positions, b[0], b[1], b[2]);
  if (first.dot(second) <= 0) return false;
  const Eigen::Vector3d normal = first.normalized();
  double gap = 0.0, longest = 0.0;
  for (const int v : b) {
    const Eigen::Vector3d offset = mesh.positions.col(v) - mesh.positions.col(a[0]);
    gap = std::max(gap, std::abs(offset.dot(normal)));
    longest = std::max(longest, offset.norm());
  }
  return gap <= kTolerance * longest;
}

/// Sides of triangles that bound a merged face: the next corner around it, per start vertex.
struct Side {
  int face, from, to;
};

/// All outer sides, sorted by merged face and start vertex.
std::vector<Side> outer_sides(const Mesh& mesh, DisjointSets& panels) {
  std::vector<Side> sides;
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for (const auto edge : by_edge(uses)) {
    if (edge.size() == 2 && panels.find(edge[0].face) == panels.find(edge[1].face)) continue;
    for (const EdgeUse& use : edge) {
      sides.push_back({panels.find(use.face), use.forward ? use.low : use.high,
                       use.forward ? use.high : use.low});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.face, a.from) < std::pair(b.face, b.from);
  });
  return sides;
}

/// Chains the sides of one merged face into its boundary; false if it is not a single loop.
bool append_loop(std::span<const Side> sides, int start, FaceList& faces) {
  const std::size_t first = faces.vertices.size();
  int at = start;
  do {
    faces.vertices.push_back(at);
    const auto side = std::lower_bound(sides.begin(), sides.end(), at,
                                       [](const Side& s, int from) { return s.from < from; });
    if (side == sides.end() || side->from != at) return false;
    at = side->to;
  } while (at != start && faces.vertices.size() - first < sides.size());
  faces.offsets.push_back(static_cast<int>(faces.vertices.size()));
  return at == start && faces.vertices.size() - first == sides.size();
}

std::vector<int> sorted_sizes(const FaceList& faces) {
  std::vector<int> sizes;
  for (std::size_t f = 1; f < faces.offsets.size(); ++f) {
    sizes.push_back(faces.offsets[f] - faces.offsets[f - 1]);
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

}  // namespace

std::vector<int> encode_fans(const Mesh& mesh) {
  std::vector<int> triangles;
  int previous_start = -1;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const std::size_t n = face.size(), start = fan_start(mesh.positions, face, previous_start);
    previous_start = face[start];
    for (std::size_t k = 1; k + 1 < n; ++k) {
      triangles.insert(triangles.end(),
                       {face[start], face[(start + k) % n], face[(start + k + 1) % n]});
    }
  }
  return triangles;
}

std::optional<FaceList> decode_fans(std::span<const int> triangles, std::span<const int> sizes) {
  FaceList faces;
  std::size_t at = 0;
  for (const int size : sizes) {
    if (size < 3) return std::nullopt;
    const auto count = static_cast<std::size_t>(size) - 2;
    if (count > (triangles.size() - at) / 3) return std::nullopt;  // 3 · count may not fit 32 bits
    const std::size_t length = 3 * count;
    if (!append_fan(triangles.subspan(at, length), faces)) return std::nullopt;
    at += length;
  }
  if (at != triangles.size()) return std::nullopt;
  return faces;
}

std::optional<FaceList> merge_coplanar(const Positions& positions, std::span<const int> triangles,
                                       std::span<const int> sizes) {
  const Mesh mesh = triangle_mesh(positions, triangles);
  DisjointSets panels(mesh.face_count());
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for (const auto edge : by_edge(uses)) {
    if (edge.size() != 2 || edge[0].forward == edge[1].forward) continue;
    if (are_coplanar(mesh, edge[0].face, edge[1].face)) panels.unite(edge[0].face, edge[1].face);
  }
  const std::vector<Side> sides = outer_sides(mesh, panels);
  FaceList faces;
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin;
    while (end < sides.size() && sides[end].face == sides[begin].face) ++end;
    const auto loop = std::span(sides).subspan(begin, end - begin);
    if (!append_loop(loop, loop.front().from, faces)) return std::nullopt;
    begin = end;
  }
  std::vector<int> wanted(sizes.begin(), sizes.end());
  std::sort(wanted.begin(), wanted.end());
  if (sorted_sizes(faces) != wanted) return std::nullopt;
  return faces;
}

bool same_up_to_rotation(const FaceList& a, const FaceList& b) {
  if (a.offsets != b.offsets || a.vertices.size() != b.vertices.size()) return false;
  for (std::size_t f = 0; f + 1 < a.offsets.size(); ++f) {
    const auto begin = a.offsets[f], end = a.offsets[f + 1];
    std::vector<int> turned(a.vertices.begin() + begin, a.vertices.begin() + end);
    const auto first =
        std::find(turned.begin(), turned.end(), b.vertices[static_cast<std::size_t>(begin)]);
    std::rotate(turned.begin(), first, turned.end());
    if (!std::equal(turned.begin(), turned.end(), b.vertices.begin() + begin)) return false;
  }
  return true;
}

}  // namespace planish
