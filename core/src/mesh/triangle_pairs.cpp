// SPDX-License-Identifier: MIT
#include "planish/mesh/triangle_pairs.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "mesh/edge_table.hpp"
#include "mesh/separate_faces.hpp"
#include "planish/mesh/area_vector.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

using Quad = std::array<int, 4>;

/// Two triangles, the lower number first, and the quad that they make.
struct Pair {
  int first = 0, second = 0;
  Quad quad{};
  double skew = 0.0;  ///< largest |cosine| of a corner
};

/// The corners of `first` with the far one of `second` between the ends of the edge.
Quad quad_of(const Mesh& mesh, int first, int second, int edge_start) {
  const auto one = mesh.face(first), other = mesh.face(second);
  Quad quad{};
  std::size_t count = 0;
  for (const int v : one) {
    quad[count++] = v;
    if (v != edge_start) continue;
    for (const int far : other) {
      if (std::find(one.begin(), one.end(), far) == one.end()) quad[count++] = far;
    }
  }
  return quad;
}

/// Largest |cosine| of the quad's corners; 2 where it is no quad: not convex seen along the mean of
/// its halves' normals, or folded by more than 60°.
double skew_of(const Mesh& mesh, const Pair& pair) {
  constexpr double kNone = 2.0, kLeastCosine = 0.5;  // of 60°
  const auto normal_of = [&](int f) {
    return Eigen::Vector3d(area_vector(mesh.positions, mesh.face(f)).normalized());
  };
  const Eigen::Vector3d first = normal_of(pair.first), second = normal_of(pair.second);
  if (!(first.dot(second) >= kLeastCosine)) return kNone;
  double skew = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector3d corner = mesh.positions.col(pair.quad[k]);
    const Eigen::Vector3d in = mesh.positions.col(pair.quad[(k + 3) % 4]) - corner;
    const Eigen::Vector3d out = mesh.positions.col(pair.quad[(k + 1) % 4]) - corner;
    if (!(out.cross(in).dot(first + second) > 0.0)) return kNone;
    skew = std::max(skew, std::abs(in.dot(out)) / (in.norm() * out.norm()));
  }
  return skew;
}

std::vector<int> group_of_faces(const Mesh& mesh) {
  std::vector<int> group(at(mesh.face_count()), -1);
  for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
    const int end = g + 1 < mesh.groups.size() ? mesh.groups[g + 1].first_face : mesh.face_count();
    std::fill(group.begin() + mesh.groups[g].first_face, group.begin() + end, static_cast<int>(g));
  }
  return group;
}

/// All pairs of triangles that make a convex quad.
std::vector<Pair> possible_pairs(const Mesh& mesh) {
  const std::vector<int> group = group_of_faces(mesh);
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  std::vector<Pair> pairs;
  for (const auto edge : by_edge(uses)) {
    if (edge.size() != 2 || edge[0].forward == edge[1].forward) continue;
    Pair pair{edge[0].face, edge[1].face, {}, 0.0};
    if (mesh.face(pair.first).size() != 3 || mesh.face(pair.second).size() != 3) continue;
    if (group[at(pair.first)] != group[at(pair.second)]) continue;
    const int start = edge[0].forward ? edge[0].low : edge[0].high;
    pair.quad = quad_of(mesh, pair.first, pair.second, start);
    pair.skew = skew_of(mesh, pair);
    if (pair.skew <= 1.0) pairs.push_back(pair);
  }
  return pairs;
}

/// The pairs 0 and 1, 2 and 3, …; empty unless all faces are in one.
std::vector<Pair> pairs_in_turn(const Mesh& mesh, const std::vector<Pair>& possible) {
  std::vector<Pair> found;
  for (const Pair& pair : possible) {
    if (pair.first % 2 == 0 && pair.second == pair.first + 1) found.push_back(pair);
  }
  if (2 * static_cast<int>(found.size()) != mesh.face_count()) found.clear();
  return found;
}

/// The best first, each triangle in one pair.
std::vector<Pair> best_pairs(const Mesh& mesh, std::vector<Pair> possible) {
  constexpr double kMostSkew = 0.866025403784438647;  // cosine of 30°
  std::sort(possible.begin(), possible.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.skew, a.first, a.second) < std::tie(b.skew, b.first, b.second);
  });
  std::vector<char> taken(at(mesh.face_count()), 0);
  std::vector<Pair> found;
  for (const Pair& pair : possible) {
    if (pair.skew > kMostSkew || taken[at(pair.first)] || taken[at(pair.second)]) continue;
    taken[at(pair.first)] = taken[at(pair.second)] = 1;
    found.push_back(pair);
  }
  return found;
}

Mesh with_quads(const Mesh& mesh, const std::vector<Pair>& pairs) {
  SeparateFaces faces = separate_faces(mesh);
  for (const Pair& pair : pairs) {
    faces.corners[at(pair.first)].assign(pair.quad.begin(), pair.quad.end());
    faces.left_out[at(pair.second)] = 1;
  }
  return with_faces(mesh, faces);
}

}  // namespace

Mesh join_triangles(const Mesh& mesh) {
  std::vector<Pair> possible = possible_pairs(mesh);
  std::vector<Pair> pairs = pairs_in_turn(mesh, possible);
  if (pairs.empty()) pairs = best_pairs(mesh, std::move(possible));
  return with_quads(mesh, pairs);
}

}  // namespace planish
