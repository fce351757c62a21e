// SPDX-License-Identifier: MIT
#include "support/obstacles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <utility>
#include <variant>

#include "planish/io/mesh_format.hpp"
#include "planish/projection/planarising.hpp"
#include "support/distances.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish::testing {
namespace {

/// A shared mesh made flat; no faces where it is absent.
Mesh flat_mesh(const std::string& name) {
  const auto bytes = shared_mesh_bytes(name + ".obj");
  if (!bytes) return {};
  Mesh mesh = std::get<MeshFile>(read_mesh(*bytes, MeshFormat::kObj)).mesh;
  const ProjectionResult flat = planarise(mesh, Planarising{});
  mesh.positions(Eigen::all, flat.moved) = flat.moved_positions;
  return mesh;
}

/// How far a panel, as the convex hull of its points, and a box are apart along the axis that parts
/// them best; negative: they meet, and would have to go that far to part.
double parted(const Box& box, const Positions& panel) {
  double widest = -INFINITY;
  const auto along = [&](Eigen::Vector3d axis) {
    if (axis.norm() < 1e-9) return;
    axis.normalize();
    double box_low = INFINITY, box_high = -INFINITY;
    for (int corner = 0; corner < 8; ++corner) {
      Eigen::Vector3d p;
      for (int c = 0; c < 3; ++c) p[c] = (corner >> c) & 1 ? box.high[c] : box.low[c];
      box_low = std::min(box_low, axis.dot(p));
      box_high = std::max(box_high, axis.dot(p));
    }
    const Eigen::RowVectorXd places = axis.transpose() * panel;
    widest = std::max({widest, places.minCoeff() - box_high, box_low - places.maxCoeff()});
  };
  const Eigen::Index n = panel.cols();
  for (int c = 0; c < 3; ++c) along(Eigen::Vector3d::Unit(c));
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Vector3d edge = panel.col((k + 1) % n) - panel.col(k);
    for (int c = 0; c < 3; ++c) along(edge.cross(Eigen::Vector3d::Unit(c)));
    for (Eigen::Index l = k + 1; l < n; ++l) {
      along(edge.cross(panel.col((l + 1) % n) - panel.col(l)));
    }
  }
  return widest;
}

/// Between a box and a panel that do not meet: of corners from the other's sides, and of edges.
double box_distance(const Box& box, const Positions& panel) {
  std::array<Eigen::Vector3d, 8> corners;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    for (int c = 0; c < 3; ++c) corners[corner][c] = (corner >> c) & 1 ? box.high[c] : box.low[c];
  }
  double least = INFINITY;
  const Eigen::Index n = panel.cols();
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Vector3d p = panel.col(k);
    least = std::min(least, (p - p.cwiseMax(box.low).cwiseMin(box.high)).norm());
    const Segment side{p, panel.col((k + 1) % n)};
    for (std::size_t corner = 0; corner < 8; ++corner) {
      for (std::size_t c = 1; c < 8; c *= 2) {
        if ((corner & c) != 0) continue;
        least = std::min(least, distance(side, Segment{corners[corner], corners[corner + c]}));
      }
      if (k + 2 >= n) continue;
      Eigen::Matrix3d triangle;
      triangle << panel.col(0), panel.col(k + 1), panel.col(k + 2);
      least = std::min(least, distance_inside(corners[corner], triangle));
    }
  }
  return least;
}

}  // namespace

std::string Plane::text() const {
  char words[160];
  std::snprintf(words, sizeof words, "plane=%.17g,%.17g,%.17g,%.17g", normal.x(), normal.y(),
                normal.z(), most);
  return words;
}

std::string Box::text() const {
  char words[240];
  std::snprintf(words, sizeof words, "box=%.17g,%.17g,%.17g,%.17g,%.17g,%.17g", low.x(), low.y(),
                low.z(), high.x(), high.y(), high.z());
  return words;
}

std::string Box::model_text() const {
  std::string words = "mesh=";
  for (std::size_t corner = 0; corner < 8; ++corner) {
    char point[120];
    std::snprintf(point, sizeof point, "%s%.17g,%.17g,%.17g", corner > 0 ? ";" : "",
                  corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                  corner & 4 ? high.z() : low.z());
    words += point;
  }
  return words + "/0,2,3,1;4,5,7,6;0,1,5,4;2,6,7,3;0,4,6,2;1,3,7,5";
}

double deepest(const Mesh& mesh, const HandleEditResult& result, const Plane& plane,
               double clearance) {
  double worst = 0.0;
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    const double was = plane.beyond(mesh.positions.col(result.moved[k])) + clearance;
    const double is =
        plane.beyond(result.moved_positions.col(static_cast<Eigen::Index>(k))) + clearance;
    worst = std::max(worst, is - std::max(was, 0.0));
  }
  return worst / mean_edge_length(mesh);
}

Mesh obstructed_mesh(const std::string& name) {
  return name.find('_') == std::string::npos ? sample(name, 16) : flat_mesh(name);
}

std::vector<Obstacle> obstacles(const Mesh& mesh, unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const double edge = mean_edge_length(mesh);
  std::vector<Obstacle> all;
  for (int k = 0; k < count; ++k) {
    Obstacle one;
    one.vertex = static_cast<int>(uniform() * mesh.vertex_count());
    Eigen::Vector3d way(uniform() - 0.5, uniform() - 0.5, 3.0 * (uniform() - 0.5));
    way.normalize();
    const double length = (0.3 + uniform()) * edge;
    one.move = length * way;
    const double place = k % 4 == 2 ? -0.3 : k % 4 == 3 ? 0.0 : 0.5;
    const Eigen::Vector3d tilt(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5);
    one.plane.normal = (way + 0.6 * tilt).normalized();
    one.plane.most = one.plane.normal.dot(mesh.positions.col(one.vertex) + place * one.move);
    all.push_back(one);
  }
  return all;
}

double worst_entry(const Mesh& mesh, const HandleEditResult& result, const Box& box,
                   double clearance) {
  const Positions after = apply(mesh, result);
  double worst = 0.0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const std::vector<int> corners(face.begin(), face.end());
    const Positions was = mesh.positions(Eigen::all, corners), is = after(Eigen::all, corners);
    if (was == is) continue;
    const double now = parted(box, is);
    const double apart = now > 0.0 ? box_distance(box, is) : now;
    worst = std::max(worst, std::min(clearance, parted(box, was)) - apart);
  }
  return worst / mean_edge_length(mesh);
}

std::vector<BoxInTheWay> boxes_near(const Mesh& mesh, unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const double edge = mean_edge_length(mesh);
  std::vector<BoxInTheWay> all;
  while (static_cast<int>(all.size()) < count) {
    BoxInTheWay one;
    one.vertex = static_cast<int>(uniform() * mesh.vertex_count());
    Eigen::Vector3d way(uniform() - 0.5, uniform() - 0.5, 3.0 * (uniform() - 0.5));
    one.move = (0.5 + 0.8 * uniform()) * edge * way.normalized();
    const Eigen::Vector3d half =
        0.5 * edge * Eigen::Vector3d(0.2 + 0.8 * uniform(), 0.2 + 0.8 * uniform(), 0.2 + uniform());
    const Eigen::Vector3d middle =
        mesh.positions.col(one.vertex) + one.move + half.norm() * 0.6 * one.move.normalized();
    one.box = {middle - half, middle + half};
    bool apart = true;
    for (int f = 0; f < mesh.face_count() && apart; ++f) {
      const auto face = mesh.face(f);
      const std::vector<int> corners(face.begin(), face.end());
      apart = parted(one.box, mesh.positions(Eigen::all, corners)) > 0.06 * edge;
    }
    if (apart) all.push_back(one);
  }
  return all;
}

}  // namespace planish::testing
