// SPDX-License-Identifier: MIT
#include "planish/point_support.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "planish/adjacency.hpp"
#include "planish/index.hpp"
#include "planish/io/number.hpp"

namespace planish {
namespace {

/// From the support to `point`, across it. @param base the same point in the base
Eigen::Vector3d way_off(const PointSupport& support, const Eigen::Vector3d& base,
                        const Eigen::Vector3d& point) {
  if (support.kind == PointSupport::Kind::kLevel) {
    return (point - base).cwiseProduct(Eigen::Vector3d::Unit(support.axis));
  }
  const Eigen::Map<const Eigen::Vector3d> first(support.numbers.data());
  if (support.kind == PointSupport::Kind::kPlane) {
    return first * ((first.dot(point) - support.numbers[3]) / first.squaredNorm());
  }
  const Eigen::Map<const Eigen::Vector3d> along(support.numbers.data() + 3);
  const Eigen::Vector3d way = point - first;
  return way - along * (along.dot(way) / along.squaredNorm());
}

/// The edges of the boundary, as pairs of vertices.
std::vector<std::pair<int, int>> boundary_edges(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      ++uses[std::minmax(face[k], face[(k + 1) % face.size()])];
    }
  }
  std::vector<std::pair<int, int>> edges;
  for (const auto& [edge, count] : uses) {
    if (count == 1) edges.push_back(edge);
  }
  return edges;
}

double distance_to_outline(const Mesh& base, const std::vector<std::pair<int, int>>& edges,
                           const Eigen::Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : edges) {
    const Eigen::Vector3d start = base.positions.col(a), along = base.positions.col(b) - start;
    const double place = std::clamp(along.dot(point - start) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (start + place * along - point).norm());
  }
  return least;
}

/// "supports: plane=0,0,1,3" without its points, which may be thousands.
std::string name_of(const PointSupport& support) {
  const std::string text = point_support_text(support);
  return "supports: " + text.substr(0, text.find(':'));
}

Refusal find_inside(const PointSupport& support, const Mesh& mesh) {
  const std::vector<int> boundary = boundary_vertices(mesh);
  for (const int v : points_of(support, mesh)) {
    if (!std::binary_search(boundary.begin(), boundary.end(), v)) {
      return "supports: outline: vertex " + std::to_string(v) + " is not on the boundary";
    }
  }
  return std::nullopt;
}

Refusal find_unsupported(const PointSupport& support, const Mesh& mesh, double most) {
  for (const int v : support.vertices) {
    if (v >= mesh.vertex_count()) {
      return name_of(support) + ": there is no vertex " + std::to_string(v) + "; the mesh has " +
             std::to_string(mesh.vertex_count()) + " (from 0)";
    }
  }
  if (support.kind == PointSupport::Kind::kOutline) return find_inside(support, mesh);
  for (const int v : points_of(support, mesh)) {
    const Eigen::Vector3d point = mesh.positions.col(v);
    const double distance = way_off(support, point, point).norm();
    if (distance > most) {
      return name_of(support) + ": vertex " + std::to_string(v) + " is " + three_digits(distance) +
             " away from it; a point slides on what it is on already";
    }
  }
  return std::nullopt;
}

}  // namespace

Refusal find_problem(const std::vector<PointSupport>& supports, const Mesh& mesh) {
  if (auto problem = find_problem(supports)) return problem;
  if (supports.empty()) return std::nullopt;
  const double most = kSupportReach * mean_edge_length(mesh);
  for (const PointSupport& support : supports) {
    if (auto problem = find_unsupported(support, mesh, most)) return problem;
  }
  return std::nullopt;
}

std::vector<int> points_of(const PointSupport& support, const Mesh& mesh) {
  if (support.points == PointSupport::Points::kBoundary) return boundary_vertices(mesh);
  std::vector<int> vertices = support.vertices;
  if (support.points == PointSupport::Points::kAll) {
    vertices.resize(at(mesh.vertex_count()));
    std::iota(vertices.begin(), vertices.end(), 0);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

double largest_distance(const PointSupport& support, const Mesh& base, const Positions& shape) {
  double largest = 0.0;
  if (support.kind == PointSupport::Kind::kOutline) {
    const auto edges = boundary_edges(base);
    for (const int v : points_of(support, base)) {
      largest = std::max(largest, distance_to_outline(base, edges, shape.col(v)));
    }
    return largest;
  }
  for (const int v : points_of(support, base)) {
    largest = std::max(largest, way_off(support, base.positions.col(v), shape.col(v)).norm());
  }
  return largest;
}

}  // namespace planish
