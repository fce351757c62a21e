// SPDX-License-Identifier: MIT
#include "planish/supports/point_support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/index.hpp"
#include "planish/supports/vertex_slides.hpp"
#include "planish/text/number.hpp"
#include "supports/surface_heights.hpp"

namespace planish {
namespace {

/// The way from the support to `point`, across it. @param base the same point in the base
Eigen::Vector3d way_off(const PointSupport& support, const Eigen::Vector3d& base,
                        const Eigen::Vector3d& point) {
  if (is_spring(support)) return point - base;
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

std::vector<std::pair<int, int>> edges_of_line(const PointSupport& support, const Mesh& mesh) {
  if (support.kind == PointSupport::Kind::kOutline) return boundary_edges(mesh);
  std::vector<std::pair<int, int>> edges;
  for (std::size_t k = 1; k < support.vertices.size(); ++k) {
    edges.emplace_back(support.vertices[k - 1], support.vertices[k]);
  }
  return edges;
}

double distance_to_line(const Mesh& base, const std::vector<std::pair<int, int>>& edges,
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
  if (support.kind == PointSupport::Kind::kSurface) return "supports: surface";
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

/// A polyline's vertices come once, each a neighbour of the next.
Refusal find_broken(const PointSupport& polyline, const Mesh& mesh) {
  const std::vector<int>& line = polyline.vertices;
  const bool closed = line.size() > 3 && line.front() == line.back();
  if (line.size() < 2) return "supports: polyline: it needs 2 vertices or more";
  if (points_of(polyline, mesh).size() + (closed ? 1 : 0) != line.size()) {
    return "supports: polyline: a vertex comes twice; only the first may, at the end of a closed "
           "one";
  }
  const Adjacency adjacency = build_adjacency(mesh);
  for (std::size_t k = 1; k < line.size(); ++k) {
    const auto around = adjacency.neighbours[line[k - 1]];
    if (std::find(around.begin(), around.end(), line[k]) != around.end()) continue;
    return "supports: polyline: no edge joins the vertices " + std::to_string(line[k - 1]) +
           " and " + std::to_string(line[k]);
  }
  return std::nullopt;
}

Refusal find_far_from_surface(const PointSupport& support, const Mesh& mesh, double mean_edge) {
  const auto far = far_from_surface(support, mesh, kSurfaceReach * mean_edge);
  if (!far) return std::nullopt;
  return name_of(support) + ": vertex " + std::to_string(far->vertex) + " is " +
         three_digits(far->distance) + " away from it, and mean edges are " +
         three_digits(mean_edge) + "; a point slides on what it is near to already";
}

/// Whether a polyline only ends there: what stands on another line as well rests there.
bool is_end(const PointSupport& support, int v) {
  const std::vector<int>& line = support.vertices;
  return support.kind == PointSupport::Kind::kPolyline && line.front() != line.back() &&
         (v == line.front() || v == line.back());
}

/// A track has one thing at a time to follow.
Refusal find_followed_twice(const std::vector<PointSupport>& supports, const Mesh& mesh) {
  using Kind = PointSupport::Kind;
  std::vector<const PointSupport*> followed(at(mesh.vertex_count()), nullptr);
  for (const PointSupport& support : supports) {
    if (!is_line_of_mesh(support) && support.kind != Kind::kSurface) continue;
    for (const int v : points_of(support, mesh)) {
      const PointSupport* other = std::exchange(followed[at(v)], &support);
      if (other == nullptr || (other->kind == Kind::kOutline && support.kind == Kind::kOutline)) {
        continue;
      }
      if (other->kind == Kind::kSurface || support.kind == Kind::kSurface) {
        return "supports: surface: vertex " + std::to_string(v) +
               " stands on another surface or a line of the mesh as well";
      }
      if (is_end(support, v) || is_end(*other, v)) continue;
      return "supports: polyline: vertex " + std::to_string(v) +
             " stands on another line as well; two may only share where one of them ends";
    }
  }
  return std::nullopt;
}

Refusal find_unsupported(const PointSupport& support, const Mesh& mesh, double mean_edge) {
  const double most = kSupportReach * mean_edge;
  for (const int v : support.vertices) {
    if (v >= mesh.vertex_count()) {
      return name_of(support) + ": there is no vertex " + std::to_string(v) + "; the mesh has " +
             std::to_string(mesh.vertex_count()) + " (from 0)";
    }
  }
  if (support.kind == PointSupport::Kind::kOutline) return find_inside(support, mesh);
  if (support.kind == PointSupport::Kind::kPolyline) return find_broken(support, mesh);
  if (support.kind == PointSupport::Kind::kSurface) {
    return find_far_from_surface(support, mesh, mean_edge);
  }
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
  const double mean_edge = mean_edge_length(mesh);
  for (const PointSupport& support : supports) {
    if (auto problem = find_unsupported(support, mesh, mean_edge)) return problem;
  }
  return find_followed_twice(supports, mesh);
}

bool is_line_of_mesh(const PointSupport& support) {
  return support.kind == PointSupport::Kind::kOutline ||
         support.kind == PointSupport::Kind::kPolyline;
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
  if (is_line_of_mesh(support)) {
    const auto edges = edges_of_line(support, base);
    for (const int v : points_of(support, base)) {
      largest = std::max(largest, distance_to_line(base, edges, shape.col(v)));
    }
    return largest;
  }
  if (support.kind == PointSupport::Kind::kSurface) {
    for (const double way : ways_off_surface(support, base, points_of(support, base), shape)) {
      largest = std::max(largest, way);
    }
    return largest;
  }
  for (const int v : points_of(support, base)) {
    largest = std::max(largest, way_off(support, base.positions.col(v), shape.col(v)).norm());
  }
  return largest;
}

}  // namespace planish
