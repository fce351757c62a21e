// SPDX-License-Identifier: MIT
#include "planish/mesh/mesh_check.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

#include "mesh/edge_table.hpp"
#include "numeric/disjoint_sets.hpp"
#include "planish/mesh/point_joining.hpp"
#include "planish/text/refusal.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

/// Twice the area over the squared perimeter below which a face counts as a line.
constexpr double kNoArea = 1e-12;

std::string at_line(const std::vector<int>& lines, int element) {
  if (lines.empty()) return "";
  return line_text(lines[static_cast<std::size_t>(element)], "");
}

std::string name(std::string_view kind, int index) {
  std::string text(kind);
  text += ' ';
  return text += std::to_string(index);
}

/// " (from 1)" after numbers that do not count from 0, as others do.
std::string counting(const SourceLines& lines) {
  return lines.first == 0 ? "" : " (from " + std::to_string(lines.first) + ")";
}

Refusal refuse_positions(const Mesh& mesh, const SourceLines& lines) {
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    for (int c = 0; c < 3; ++c) {
      const double value = mesh.positions(c, v);
      if (std::abs(value) <= kLargestCoordinate) continue;  // false for NaN
      return at_line(lines.vertices, v) + name("vertex", v + lines.first) + counting(lines) +
             " has the coordinate " + number_text(value) +
             (std::isfinite(value) ? ", which is larger than 1e100" : ", which is not finite");
    }
  }
  return std::nullopt;
}

/// `last_face_of` remembers, per vertex, the last face seen there: repeats show in O(1).
Refusal refuse_face(const Mesh& mesh, int f, const SourceLines& lines,
                    std::vector<int>& last_face_of) {
  const auto face = mesh.face(f);
  const auto refusal = [&](const std::string& what) {
    return at_line(lines.faces, f) + name("face", lines.number_of_face(f)) + " " + what;
  };
  if (face.size() < 3) {
    return refusal("has " + count_text(face.size(), "vertex", "vertices") + "; it needs 3 or more");
  }
  for (const int v : face) {
    if (v < 0 || v >= mesh.vertex_count()) {
      return refusal(
          "uses " + name("vertex", v + lines.first) + ", but the mesh has " +
          count_text(static_cast<std::size_t>(mesh.vertex_count()), "vertex", "vertices") +
          " (from " + std::to_string(lines.first) + ")");
    }
    int& last = last_face_of[static_cast<std::size_t>(v)];
    if (last == f)
      return refusal("uses " + name("vertex", v + lines.first) + " twice" + counting(lines));
    last = f;
  }
  return std::nullopt;
}

Refusal refuse_faces(const Mesh& mesh, const SourceLines& lines) {
  if (mesh.face_count() < 1) return "the file holds no faces";
  std::vector<int> last_face_of(static_cast<std::size_t>(mesh.vertex_count()), -1);
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (Refusal refusal = refuse_face(mesh, f, lines, last_face_of)) return refusal;
  }
  return std::nullopt;
}

/// Two faces of an edge's with the same corners, in whatever order; the later one second.
std::optional<std::pair<int, int>> given_twice(const Mesh& mesh, std::span<const EdgeUse> edge) {
  std::vector<std::pair<std::vector<int>, int>> faces;
  for (const EdgeUse& use : edge) {
    const auto face = mesh.face(use.face);
    faces.emplace_back(std::vector<int>(face.begin(), face.end()), use.face);
    std::sort(faces.back().first.begin(), faces.back().first.end());
  }
  std::sort(faces.begin(), faces.end());
  for (std::size_t k = 1; k < faces.size(); ++k) {
    if (faces[k - 1].first == faces[k].first)
      return std::pair(faces[k - 1].second, faces[k].second);
  }
  return std::nullopt;
}

Refusal refuse_edges(const Mesh& mesh, const std::vector<EdgeUse>& uses, const SourceLines& lines) {
  for (const auto edge : by_edge(uses)) {
    if (edge.size() <= 2) continue;
    const auto number = [&](int index) { return std::to_string(index + lines.first); };
    const auto face_number = [&](int f) { return std::to_string(lines.number_of_face(f)); };
    if (const auto twice = given_twice(mesh, edge)) {
      return at_line(lines.faces, twice->second) + "face " + face_number(twice->second) +
             " has the same corners as face " + face_number(twice->first) + counting(lines) +
             "; a panel can be given once";
    }
    return at_line(lines.faces, edge[2].face) + "the edge between vertices " + number(edge[0].low) +
           " and " + number(edge[0].high) + " is shared by " + std::to_string(edge.size()) +
           " faces, among them " + face_number(edge[0].face) + " and " + face_number(edge[2].face) +
           counting(lines) + "; an edge can have at most 2";
  }
  return std::nullopt;
}

Refusal refuse_zero_size(const Mesh& mesh, const std::vector<EdgeUse>& uses) {
  for (const EdgeUse& use : uses) {
    if ((mesh.positions.col(use.low) - mesh.positions.col(use.high)).norm() > 0) {
      return std::nullopt;
    }
  }
  return "all edges have length zero";
}

std::optional<std::string> orientation_warning(const Mesh& mesh, const std::vector<EdgeUse>& uses) {
  DisjointSets sides(mesh.face_count());
  std::size_t clashes = 0;
  bool orientable = true;
  std::string first;
  for (const auto edge : by_edge(uses)) {
    if (edge.size() != 2) continue;
    const bool clash = edge[0].forward == edge[1].forward;
    if (!sides.unite(edge[0].face, edge[1].face, clash)) orientable = false;
    if (clash && clashes++ == 0) {
      first = "faces " + std::to_string(edge[0].face) + " and " + std::to_string(edge[1].face);
    }
  }
  if (clashes == 0) return std::nullopt;
  return count_text(clashes, "edge lies", "edges lie") +
         " between faces of opposite orientation (first: " + first + "); " +
         (orientable ? "the faces are kept as they are; convert --orient turns them"
                     : "the surface has one side only and is kept as it is");
}

/// How the faces hang together at their corners.
struct CornerTopology {
  int boundary_loops = 0;
  int pinch_vertices = 0, first_pinch = -1;
};

/// Corners (a face at a vertex) that share an edge form fans; a vertex with two fans is a pinch.
/// Boundary edges that end in the same fan follow each other on one loop.
CornerTopology corner_topology(const Mesh& mesh, const std::vector<EdgeUse>& uses) {
  const int corners = static_cast<int>(mesh.face_vertices.size());
  DisjointSets fans(corners);
  for (const auto edge : by_edge(uses)) {
    if (edge.size() != 2) continue;
    const bool same_way = edge[0].forward == edge[1].forward;
    fans.unite(edge[0].corner, same_way ? edge[1].corner : edge[1].next_corner);
    fans.unite(edge[0].next_corner, same_way ? edge[1].next_corner : edge[1].corner);
  }
  CornerTopology topology;
  std::vector<int> fan_of(static_cast<std::size_t>(mesh.vertex_count()), -1);
  std::vector<char> pinched(fan_of.size(), 0);
  for (int corner = 0; corner < corners; ++corner) {
    const auto v = static_cast<std::size_t>(mesh.face_vertices[static_cast<std::size_t>(corner)]);
    const int fan = fans.find(corner);
    if (fan_of[v] < 0) fan_of[v] = fan;
    if (fan_of[v] == fan || pinched[v]) continue;
    pinched[v] = 1;
    const int vertex = static_cast<int>(v);
    if (topology.pinch_vertices++ == 0 || vertex < topology.first_pinch) {
      topology.first_pinch = vertex;
    }
  }
  DisjointSets loops(corners);
  std::vector<int> boundary_fans;
  for (const auto edge : by_edge(uses)) {
    if (edge.size() != 1) continue;
    boundary_fans.push_back(fans.find(edge[0].corner));
    loops.unite(boundary_fans.back(), fans.find(edge[0].next_corner));
  }
  for (int& fan : boundary_fans) fan = loops.find(fan);
  std::sort(boundary_fans.begin(), boundary_fans.end());
  boundary_fans.erase(std::unique(boundary_fans.begin(), boundary_fans.end()), boundary_fans.end());
  topology.boundary_loops = static_cast<int>(boundary_fans.size());
  return topology;
}

void warn_pinches(const Mesh& mesh, const std::vector<EdgeUse>& uses,
                  std::vector<std::string>& warnings) {
  const CornerTopology topology = corner_topology(mesh, uses);
  if (topology.pinch_vertices == 0) return;
  warnings.push_back(count_text(static_cast<std::size_t>(topology.pinch_vertices), "vertex joins",
                                "vertices join") +
                     " faces that share no edge there (first: " +
                     name("vertex", topology.first_pinch) + "); they are kept as they are");
}

std::vector<char> used_vertices(const Mesh& mesh) {
  std::vector<char> used(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (const int v : mesh.face_vertices) used[static_cast<std::size_t>(v)] = 1;
  return used;
}

void warn_isolated(const Mesh& mesh, std::vector<std::string>& warnings) {
  const std::vector<char> used = used_vertices(mesh);
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
  if (count == 0) return;
  const auto first = std::find(used.begin(), used.end(), 0) - used.begin();
  warnings.push_back(count_text(count, "vertex belongs", "vertices belong") +
                     " to no face (first: " + name("vertex", static_cast<int>(first)) +
                     "); they are kept and never move");
}

/// Newell's area against the perimeter, so that the scale does not matter.
bool has_area(const Mesh& mesh, int f) {
  const auto face = mesh.face(f);
  const Eigen::Vector3d origin = mesh.positions.col(face[0]);
  Eigen::Vector3d twice_area = Eigen::Vector3d::Zero();
  double perimeter = 0.0;
  Eigen::Vector3d previous = mesh.positions.col(face.back()) - origin;
  for (const int v : face) {
    const Eigen::Vector3d point = mesh.positions.col(v) - origin;
    twice_area += previous.cross(point);
    perimeter += (point - previous).norm();
    previous = point;
  }
  return twice_area.norm() > kNoArea * perimeter * perimeter;
}

void warn_flattened(const Mesh& mesh, std::vector<std::string>& warnings) {
  std::size_t count = 0;
  int first = -1;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (!has_area(mesh, f) && count++ == 0) first = f;
  }
  if (count == 0) return;
  warnings.push_back(count_text(count, "face encloses", "faces enclose") +
                     " no area (first: " + name("face", first) + "); they are kept as they are");
}

/// Equal keys for equal positions; −0 counts as 0.
std::uint64_t position_key(const Mesh& mesh, int v) {
  std::uint64_t key = 0x9E3779B97F4A7C15u;
  for (int c = 0; c < 3; ++c) {
    const double value = mesh.positions(c, v) + 0.0;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    key = (key ^ bits) * 0xBF58476D1CE4E5B9u;
    key ^= key >> 31;
  }
  return key;
}

void warn_coincident(const Mesh& mesh, std::vector<std::string>& warnings) {
  std::vector<std::pair<std::uint64_t, int>> keys;
  keys.reserve(static_cast<std::size_t>(mesh.vertex_count()));
  for (int v = 0; v < mesh.vertex_count(); ++v) keys.emplace_back(position_key(mesh, v), v);
  std::sort(keys.begin(), keys.end());
  std::size_t count = 0;
  std::pair<int, int> first{-1, -1};
  for (std::size_t k = 1; k < keys.size(); ++k) {
    const int a = keys[k - 1].second, b = keys[k].second;
    if (keys[k - 1].first != keys[k].first) continue;
    if (mesh.positions.col(a) != mesh.positions.col(b)) continue;
    if (count++ == 0 || std::pair(a, b) < first) first = {a, b};
  }
  if (count == 0) return;
  warnings.push_back(count_text(count, "vertex lies", "vertices lie") +
                     " exactly where another one does (first: vertices " +
                     std::to_string(first.first) + " and " + std::to_string(first.second) +
                     "); they are not joined; convert --join-points joins them");
}

int component_count(const Mesh& mesh) {
  DisjointSets pieces(mesh.vertex_count());
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const int v : mesh.face(f)) pieces.unite(mesh.face(f)[0], v);
  }
  const std::vector<char> used = used_vertices(mesh);
  int count = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (used[static_cast<std::size_t>(v)] && pieces.find(v) == v) ++count;
  }
  return count;
}

/// Vertices of edges that one face has, ascending.
std::vector<int> boundary_points(const std::vector<EdgeUse>& uses) {
  std::vector<int> points;
  for (const auto edge : by_edge(uses)) {
    if (edge.size() == 1) points.insert(points.end(), {edge[0].low, edge[0].high});
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Warns of points where parts meet that differ by rounding.
void warn_nearly_coincident(const Mesh& mesh, const std::vector<EdgeUse>& uses,
                            std::vector<std::string>& warnings) {
  if (component_count(mesh) < 2) return;
  const std::vector<int> points = boundary_points(uses);
  const Positions places = mesh.positions(Eigen::all, points);
  const JoinedPoints joined = find_joined_points(places, usual_joining(mesh));
  if (joined.largest == 0.0) return;
  std::size_t count = 0;
  std::pair<int, int> first{-1, -1};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const int kept = joined.kept[static_cast<std::size_t>(joined.target[k])];
    if (places.col(static_cast<Eigen::Index>(k)) == places.col(kept)) continue;
    if (count++ == 0) first = {points[static_cast<std::size_t>(kept)], points[k]};
  }
  warnings.push_back(count_text(count, "vertex lies", "vertices lie") + " within " +
                     number_text(joined.largest) + " of another one (first: vertices " +
                     std::to_string(first.first) + " and " + std::to_string(first.second) +
                     "); they are not joined; convert --join-points joins them");
}

}  // namespace

ReadResult check_mesh(Mesh mesh, const SourceLines& lines) {
  if (Refusal refusal = refuse_positions(mesh, lines)) return ReadError{*refusal};
  if (Refusal refusal = refuse_faces(mesh, lines)) return ReadError{*refusal};
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  if (Refusal refusal = refuse_edges(mesh, uses, lines)) return ReadError{*refusal};
  if (Refusal refusal = refuse_zero_size(mesh, uses)) return ReadError{*refusal};
  std::vector<std::string> warnings;
  if (auto warning = orientation_warning(mesh, uses)) warnings.push_back(std::move(*warning));
  warn_pinches(mesh, uses, warnings);
  warn_isolated(mesh, warnings);
  warn_flattened(mesh, warnings);
  warn_coincident(mesh, warnings);
  warn_nearly_coincident(mesh, uses, warnings);
  return MeshFile{std::move(mesh), std::move(warnings)};
}

std::optional<std::string> orientation_warning(const Mesh& mesh) {
  return orientation_warning(mesh, edge_uses(mesh));
}

MeshSummary summarize(const Mesh& mesh) {
  MeshSummary summary;
  summary.vertices = mesh.vertex_count();
  summary.faces = mesh.face_count();
  for (int f = 0; f < mesh.face_count(); ++f) {
    ++summary.face_sizes[static_cast<int>(mesh.face(f).size())];
  }
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for (const auto edge : by_edge(uses)) summary.nonmanifold_edges += edge.size() > 2 ? 1 : 0;
  const CornerTopology topology = corner_topology(mesh, uses);
  summary.boundary_loops = topology.boundary_loops;
  summary.pinch_vertices = topology.pinch_vertices;
  summary.components = component_count(mesh);
  const std::vector<char> used = used_vertices(mesh);
  summary.isolated_vertices = static_cast<int>(std::count(used.begin(), used.end(), 0));
  summary.mean_edge = mean_edge_length(mesh);
  return summary;
}

}  // namespace planish
