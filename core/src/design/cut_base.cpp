// SPDX-License-Identifier: MIT
#include "planish/design/cut_base.hpp"

#include <algorithm>
#include <utility>

#include "planish/edit/symmetric_edit.hpp"
#include "planish/mesh/adjacency.hpp"

namespace planish {
namespace {

/// The symmetry of `elements` on the cut mesh, whose added points are evened out.
std::variant<MeshSymmetry, std::string> symmetry_after_cuts(
    Mesh& mesh, const std::vector<SymmetryElement>& elements, double tolerance) {
  auto found = find_symmetry(mesh, {false, elements});
  if (std::holds_alternative<std::string>(found)) {
    return "symmetry: the cuts are not symmetric; their images must be cut, too";
  }
  if (!make_symmetric(mesh, std::get<MeshSymmetry>(found), tolerance).symmetric) {
    return "symmetry: the mesh after the cuts cannot be made symmetric";
  }
  return found;
}

/// Whether a point that was added on a side stands where the side's ends do.
bool goes_along(const PointSupport& support, int vertex, const std::vector<int>& boundary) {
  if (support.kind != PointSupport::Kind::kOutline) return true;
  return std::binary_search(boundary.begin(), boundary.end(), vertex);
}

void add_to_list(PointSupport& support, const CutMesh& cut, const std::vector<int>& boundary) {
  std::vector<int> listed = support.vertices;
  std::sort(listed.begin(), listed.end());
  const auto has = [&](int v) { return std::binary_search(listed.begin(), listed.end(), v); };
  for (const AddedPoint& point : cut.added) {
    if (point.panel >= 0 || !has(point.from) || !has(point.to) || has(point.vertex)) continue;
    if (goes_along(support, point.vertex, boundary)) support.vertices.push_back(point.vertex);
  }
}

/// Points that cuts added on the side between two points, from the first on.
std::vector<int> added_between(int first, int last, const CutMesh& cut) {
  std::vector<std::pair<double, int>> found;
  const auto ends = std::minmax(first, last);
  for (const AddedPoint& point : cut.added) {
    if (point.panel >= 0 || point.from != ends.first || point.to != ends.second) continue;
    const auto& positions = cut.mesh.positions;
    found.emplace_back((positions.col(point.vertex) - positions.col(first)).squaredNorm(),
                       point.vertex);
  }
  std::sort(found.begin(), found.end());
  std::vector<int> vertices;
  vertices.reserve(found.size());
  for (const auto& [distance, vertex] : found) vertices.push_back(vertex);
  return vertices;
}

void add_to_polyline(PointSupport& polyline, const CutMesh& cut) {
  std::vector<int> line;
  for (const int v : polyline.vertices) {
    if (!line.empty()) {
      const std::vector<int> between = added_between(line.back(), v, cut);
      line.insert(line.end(), between.begin(), between.end());
    }
    line.push_back(v);
  }
  polyline.vertices = std::move(line);
}

}  // namespace

std::variant<CutMesh, std::string> cut_base(const Mesh& flat, const std::vector<Cut>& cuts,
                                            std::optional<MeshSymmetry>& symmetry,
                                            double tolerance) {
  auto made = cut_mesh(flat, cuts);
  if (std::holds_alternative<std::string>(made) || !symmetry) return made;
  auto again = symmetry_after_cuts(std::get<CutMesh>(made).mesh, symmetry->elements, tolerance);
  if (auto* why = std::get_if<std::string>(&again)) return std::move(*why);
  symmetry = std::get<MeshSymmetry>(std::move(again));
  return made;
}

std::vector<PointSupport> supports_after_cuts(const std::vector<PointSupport>& supports,
                                              const CutMesh& cut) {
  std::vector<PointSupport> carried = supports;
  const std::vector<int> boundary = boundary_vertices(cut.mesh);
  for (PointSupport& support : carried) {
    if (support.kind == PointSupport::Kind::kPolyline) {
      add_to_polyline(support, cut);
    } else if (support.points == PointSupport::Points::kListed) {
      add_to_list(support, cut, boundary);
    }
  }
  return carried;
}

}  // namespace planish
