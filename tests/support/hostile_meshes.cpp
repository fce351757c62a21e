// SPDX-License-Identifier: MIT
#include "support/hostile_meshes.hpp"

#include <cmath>
#include <utility>

#include "planish/shapes/shapes.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish::testing {
namespace {

double bump(double i, double j) { return 0.1 * i * i - 0.07 * j * j + 0.05 * i * j; }

Mesh coincident_vertices() {
  Mesh mesh = quad_grid(5, 5, bump);
  mesh.positions.col(7) = mesh.positions.col(6);
  mesh.positions.col(18) = mesh.positions.col(17);
  return mesh;
}

/// A row of quads pressed into a line, and one into a point.
Mesh zero_area() {
  Mesh mesh = quad_grid(5, 5, bump);
  for (int i = 0; i < 5; ++i) mesh.positions.col(10 + i) = mesh.positions.col(5 + i);
  for (const int v : {19, 23, 24}) mesh.positions.col(v) = mesh.positions.col(18);
  return mesh;
}

Mesh collinear_panel() {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 0.2}, {3, 1, 0}},
                   {{0, 1, 2, 3}, {0, 3, 5, 4}});
}

Mesh self_crossing() {
  Mesh mesh = quad_grid(5, 5, bump);
  const Eigen::Vector3d first = mesh.positions.col(12);
  mesh.positions.col(12) = mesh.positions.col(13);
  mesh.positions.col(13) = first;
  return mesh;
}

Mesh folded_back() {
  Mesh mesh = quad_grid(5, 4, bump);
  for (int j = 0; j < 4; ++j) mesh.positions.col(j * 5 + 4) = mesh.positions.col(j * 5 + 2);
  return mesh;
}

/// Hexagons whose every second corner belongs to one or two faces only.
Mesh valence_two() {
  return make_mesh({{0, 0, 0},
                    {1, 0, 0},
                    {2, 0, 0.1},
                    {0, 1, 0},
                    {2, 1, 0.2},
                    {0, 2, 0.1},
                    {1, 2, 0},
                    {2, 2, 0},
                    {1, 0.5, 0.3},
                    {1, 1.5, 0}},
                   {{0, 1, 8, 9, 6, 5, 3}, {1, 2, 4, 7, 6, 9, 8}});
}

Mesh single_panel(int corners) {
  std::vector<Eigen::Vector3d> points;
  std::vector<int> face;
  for (int k = 0; k < corners; ++k) {
    const double angle = 6.283185307179586 * k / corners;
    points.emplace_back(std::cos(angle), std::sin(angle), 0.01 * std::sin(3.0 * angle));
    face.push_back(k);
  }
  return make_mesh(points, {face});
}

Mesh cube() {
  return make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1.1}, {1, 1, 1}, {0, 1, 1}},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

/// A torus of quads.
Mesh torus() {
  constexpr int kRound = 10, kTube = 6;
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < kRound; ++i) {
    for (int j = 0; j < kTube; ++j) {
      const double a = 6.283185307179586 * i / kRound,
                   b = 6.283185307179586 * (j + 0.3 * i) / kTube;
      const double r = 3.0 + std::cos(b);
      points.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
      const int i1 = (i + 1) % kRound, j1 = (j + 1) % kTube;
      faces.push_back({i * kTube + j, i1 * kTube + j, i1 * kTube + j1, i * kTube + j1});
    }
  }
  return make_mesh(points, faces);
}

Mesh moebius() {
  constexpr int kRound = 16;
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < kRound; ++i) {
    const double a = 6.283185307179586 * i / kRound;
    for (const double side : {-0.4, 0.4}) {
      const double r = 2.0 + side * std::cos(a / 2);
      points.emplace_back(r * std::cos(a), r * std::sin(a), side * std::sin(a / 2));
    }
    const int a0 = 2 * i, b0 = 2 * i + 1;
    const bool last = i + 1 == kRound;
    const int a1 = last ? 1 : a0 + 2, b1 = last ? 0 : b0 + 2;
    faces.push_back({a0, a1, b1, b0});
  }
  return make_mesh(points, faces);
}

Mesh two_of(const Mesh& mesh, const Eigen::Vector3d& apart) {
  Mesh both = mesh;
  const int n = mesh.vertex_count();
  both.positions.conservativeResize(3, 2 * n);
  both.positions.rightCols(n) = mesh.positions.colwise() + apart;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const int v : mesh.face(f)) both.face_vertices.push_back(v + n);
    both.face_offsets.push_back(static_cast<int>(both.face_vertices.size()));
  }
  return both;
}

Mesh placed(Mesh mesh, double scale, double offset) {
  mesh.positions = (mesh.positions.array() * scale + offset).matrix();
  return mesh;
}

}  // namespace

std::vector<NamedMesh> hostile_meshes() {
  const Mesh vault = make_sample("vault", 6).value();
  const Mesh saddle = quad_grid(6, 6, bump);
  std::vector<NamedMesh> list;
  const auto add = [&](const char* name, Mesh mesh, int handle) {
    list.push_back({name, std::move(mesh), handle});
  };
  add("coincident vertices", coincident_vertices(), 12);
  add("zero-area panels", zero_area(), 12);
  add("collinear panel", collinear_panel(), 4);
  add("self-crossing panels", self_crossing(), 12);
  add("folded back", folded_back(), 7);
  add("valence two", valence_two(), 8);
  add("all triangles", triangle_grid(5, 5), 12);
  add("single quad", make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0}}, {{0, 1, 2, 3}}), 2);
  add("single triangle", make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}}), 2);
  add("single 40-gon", single_panel(40), 3);
  add("cube", cube(), 5);
  add("torus", torus(), 7);
  add("moebius", moebius(), 9);
  add("two components", two_of(saddle, {20, 0, 0}), 14);
  add("the same twice", two_of(vault, {0, 0, 0}), 14);
  add("1e-6", placed(saddle, 1e-6, 0), 14);
  add("1e9", placed(saddle, 1e9, 0), 14);
  add("1e-6 flat", placed(vault, 1e-6, 0), 14);
  add("1e9 flat", placed(vault, 1e9, 0), 14);
  add("offset 1e7", placed(saddle, 1, 1e7), 14);
  add("offset 1e7 flat", placed(vault, 1, 1e7), 14);
  add("1e-6 at 1e7", placed(saddle, 1e-6, 1e7), 14);
  add("1e100", placed(saddle, 1e97, 0), 14);
  add("10,000 corners", single_panel(10000), 17);
  return list;
}

}  // namespace planish::testing
