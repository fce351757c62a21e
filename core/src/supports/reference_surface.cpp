// SPDX-License-Identifier: MIT
#include "supports/reference_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "planish/numeric/index.hpp"

namespace planish {
namespace {

Mesh fans_of(const Mesh& mesh) {
  Mesh fans;
  fans.positions = mesh.positions;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      fans.face_vertices.insert(fans.face_vertices.end(), {face[0], face[k], face[k + 1]});
      fans.face_offsets.push_back(static_cast<int>(fans.face_vertices.size()));
    }
  }
  return fans;
}

/// Weights of the corners at the place of a triangle that is nearest to `p`.
Eigen::Vector3d nearest_weights(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double t = d1 / (d1 - d3);
    return {1.0 - t, t, 0.0};
  }
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double t = d2 / (d2 - d6);
    return {1.0 - t, 0.0, t};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - t, t};
  }
  const double whole = va + vb + vc;
  return {va / whole, vb / whole, vc / whole};
}

Eigen::AlignedBox3d box_around(const Eigen::Vector3d& point, double reach) {
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(reach);
  return {Eigen::Vector3d(point - half), Eigen::Vector3d(point + half)};
}

}  // namespace

Mesh to_mesh(const ContextMesh& context) {
  Mesh mesh;
  mesh.positions.resize(3, static_cast<Eigen::Index>(context.points.size()));
  for (std::size_t k = 0; k < context.points.size(); ++k) {
    mesh.positions.col(static_cast<Eigen::Index>(k)) =
        Eigen::Map<const Eigen::Vector3d>(context.points[k].data());
  }
  for (const std::vector<int>& panel : context.panels) {
    mesh.face_vertices.insert(mesh.face_vertices.end(), panel.begin(), panel.end());
    mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
  }
  return mesh;
}

ReferenceSurface::ReferenceSurface(const Mesh& mesh)
    : triangles_(fans_of(mesh)),
      boxes_(triangles_, triangles_.positions),
      sites_(mesh),
      step_(mean_edge_length(mesh)) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    panel_of_.insert(panel_of_.end(), mesh.face(f).size() - 2, f);
  }
}

bool ReferenceSurface::is_of(int facet, int side) const {
  return side == kAnySide || sites_.side(panel_of_[at(facet)]) == side;
}

Eigen::Vector3d ReferenceSurface::nearest_place(int facet, const Eigen::Vector3d& point) const {
  const auto corner = triangles_.face(facet);
  const Eigen::Vector3d a = triangles_.positions.col(corner[0]),
                        b = triangles_.positions.col(corner[1]),
                        c = triangles_.positions.col(corner[2]);
  const Eigen::Vector3d weights = nearest_weights(point, a, b, c);
  return weights[0] * a + weights[1] * b + weights[2] * c;
}

Eigen::Vector3d ReferenceSurface::somewhere_near(const Eigen::Vector3d& point, int side) const {
  for (double reach = step_;; reach *= 2.0) {
    for (const int f : boxes_.near(box_around(point, reach))) {
      if (is_of(f, side)) return triangles_.positions.col(triangles_.face(f).front());
    }
    if (!(reach < std::numeric_limits<double>::max())) return point;
  }
}

ReferenceSurface::FacetPlace ReferenceSurface::nearest(const Eigen::Vector3d& point, int side,
                                                       const Eigen::Vector3d& near) const {
  constexpr double kRounding = 1.0 + 1e-9;
  FacetPlace best;
  double least = std::numeric_limits<double>::infinity();
  const double reach = kRounding * (point - near).norm() + 1e-9 * step_;
  for (const int f : boxes_.near(box_around(point, reach))) {
    if (!is_of(f, side)) continue;
    const Eigen::Vector3d place = nearest_place(f, point);
    const double distance = (point - place).norm();
    if (!(distance < least)) continue;
    least = distance;
    best = {f, place};
  }
  return best;
}

SurfaceFoot ReferenceSurface::foot(const Eigen::Vector3d& point, int side,
                                   const Eigen::Vector3d& near) const {
  const auto [facet, place] = nearest(point, side, near);
  if (facet < 0) return {};
  return {place, sites_.height(panel_of_[at(facet)], point)};
}

double ReferenceSurface::distance(const Eigen::Vector3d& point) const {
  return (nearest(point, kAnySide, somewhere_near(point, kAnySide)).place - point).norm();
}

std::vector<int> ReferenceSurface::sides_at(const Eigen::Vector3d& point, std::size_t most) const {
  const double reach = distance(point) + 1e-9 * step_;
  std::vector<int> sides;
  for (const int f : boxes_.near(box_around(point, reach))) {
    const int side = sites_.side(panel_of_[at(f)]);
    const bool is_new = std::find(sides.begin(), sides.end(), side) == sides.end();
    if (is_new && (nearest_place(f, point) - point).norm() <= reach) sides.push_back(side);
  }
  std::sort(sides.begin(), sides.end());
  sides.resize(std::min(sides.size(), most));
  return sides;
}

}  // namespace planish
