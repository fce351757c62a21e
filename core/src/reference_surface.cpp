// SPDX-License-Identifier: MIT
#include "reference_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "planish/index.hpp"

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

/// Twice the area vector of each triangle.
Eigen::Matrix3Xd areas_of(const Mesh& triangles) {
  Eigen::Matrix3Xd areas(3, triangles.face_count());
  for (int f = 0; f < triangles.face_count(); ++f) {
    const auto corner = triangles.face(f);
    const Eigen::Vector3d a = triangles.positions.col(corner[0]);
    const Eigen::Vector3d ab = triangles.positions.col(corner[1]) - a;
    areas.col(f) = ab.cross(Eigen::Vector3d(triangles.positions.col(corner[2]) - a));
  }
  return areas;
}

/// Of the triangles around each corner that are no sharp edge away, by their areas.
Eigen::Matrix3Xd corner_normals(const Mesh& triangles) {
  constexpr double kLeastCosine = 0.866025403784438647;  // of 30°
  const Eigen::Matrix3Xd areas = areas_of(triangles);
  std::vector<std::vector<int>> around(at(triangles.vertex_count()));
  for (int f = 0; f < triangles.face_count(); ++f) {
    for (const int v : triangles.face(f)) around[at(v)].push_back(f);
  }
  Eigen::Matrix3Xd normals(3, 3 * triangles.face_count());
  for (int f = 0; f < triangles.face_count(); ++f) {
    const Eigen::Vector3d own = areas.col(f);
    for (int k = 0; k < 3; ++k) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const int g : around[at(triangles.face(f)[at(k)])]) {
        const Eigen::Vector3d other = areas.col(g);
        if (own.dot(other) >= kLeastCosine * own.norm() * other.norm()) sum += other;
      }
      normals.col(3 * f + k) = sum.normalized();
    }
  }
  return normals;
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
      normals_(corner_normals(triangles_)),
      boxes_(triangles_, triangles_.positions),
      step_(mean_edge_length(mesh)) {}

Eigen::Vector3d ReferenceSurface::somewhere_near(const Eigen::Vector3d& point) const {
  for (double reach = step_;; reach *= 2.0) {
    const std::vector<int> near = boxes_.near(box_around(point, reach));
    if (!near.empty()) return triangles_.positions.col(triangles_.face(near.front()).front());
    if (!(reach < std::numeric_limits<double>::max())) return point;
  }
}

SurfaceFoot ReferenceSurface::foot(const Eigen::Vector3d& point,
                                   const Eigen::Vector3d& near) const {
  constexpr double kRounding = 1.0 + 1e-9;
  SurfaceFoot best;
  int facet = -1;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  best.distance = std::numeric_limits<double>::infinity();
  const double reach = kRounding * (point - near).norm() + 1e-9 * step_;
  for (const int f : boxes_.near(box_around(point, reach))) {
    const auto corner = triangles_.face(f);
    const Eigen::Vector3d a = triangles_.positions.col(corner[0]),
                          b = triangles_.positions.col(corner[1]),
                          c = triangles_.positions.col(corner[2]);
    const Eigen::Vector3d here = nearest_weights(point, a, b, c);
    const Eigen::Vector3d place = here[0] * a + here[1] * b + here[2] * c;
    const double distance = (point - place).norm();
    if (!(distance < best.distance)) continue;
    best.distance = distance;
    best.place = place;
    weights = here;
    facet = f;
  }
  if (facet < 0) return best;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(), smooth = best.place;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d one = normals_.col(3 * facet + k);
    const Eigen::Vector3d corner = triangles_.positions.col(triangles_.face(facet)[at(k)]);
    normal += weights[k] * one;
    smooth -= weights[k] * one.dot(best.place - corner) * one;
  }
  best.normal = normal.normalized();
  best.height = best.normal.dot(point - smooth);
  return best;
}

}  // namespace planish
