// SPDX-License-Identifier: MIT
#include "shapes/grid_shapes.hpp"

#include <algorithm>
#include <vector>

#include "numeric/trigonometry.hpp"
#include "shapes/placement.hpp"

namespace planish {
namespace {

/// columns × rows points given by `point(i, j)`, index j · columns + i, and the quads between.
template <class Point>
Mesh make_grid(int columns, int rows, const Point& point) {
  Mesh mesh;
  mesh.positions.resize(3, static_cast<Eigen::Index>(columns) * rows);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      mesh.positions.col(static_cast<Eigen::Index>(j) * columns + i) = point(i, j);
    }
  }
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      const int a = j * columns + i;
      mesh.face_vertices.insert(mesh.face_vertices.end(), {a, a + 1, a + columns + 1, a + columns});
      mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
    }
  }
  return mesh;
}

/// One profile of the freeform roof, s in −1 … 1 along its length.
Eigen::Vector3d long_profile(double s) {
  return {1.35 * s, 0.16 * sine(1.9 * s + 0.5), 0.20 * cosine(2.7 * s - 0.35) - 0.10 * s};
}

/// The other one: an arch that leans and runs out flat on one side.
Eigen::Vector3d cross_profile(double t) {
  return {0.10 * t * t - 0.06 * t, 0.92 * t, 0.34 * cosine(1.75 * t + 0.25) + 0.03 * t};
}

}  // namespace

Mesh make_vault(int size) {
  const double n = size - 1;
  const auto height_u = [&](double u) { return 0.12 * sine(kPi * u); };
  const auto height_v = [&](double v) { return 0.10 * sine(kPi * v) + 0.02 * sine(4.0 * kPi * v); };
  return make_grid(size, size, [&](int i, int j) {
    const double u = i / n, v = j / n;
    return Eigen::Vector3d(n * u, n * v, n * (height_u(u) + height_v(v)));
  });
}

Mesh make_dome(int size) {
  const double n = size - 1;
  return make_grid(size, size, [&](int i, int j) {
    const double theta = 2.0 * (i / n) - 1.0, v = j / n;
    const double r = n * (0.6 + 0.25 * sine(2.5 * v));
    return Eigen::Vector3d(r * sine(theta), r * cosine(theta), 1.2 * n * v);
  });
}

Mesh make_roof(int size) {
  // Odd numbers: a point is in the middle.
  const int columns = 1 + 2 * std::max(1, static_cast<int>(size * 0.59));
  const int rows = 1 + 2 * std::max(1, static_cast<int>(0.5 * size * size / columns));
  constexpr double kHalfSpan = 1.1, kHalfWidth = 0.8;  // radians: of the two arcs
  const double around = 0.5 * (columns - 1) / kHalfSpan, across = 0.5 * (rows - 1) / kHalfWidth;
  Mesh mesh = make_grid(columns, rows, [&](int i, int j) {
    const double u = kHalfSpan * (2.0 * i / (columns - 1) - 1.0);
    const double v = kHalfWidth * (2.0 * j / (rows - 1) - 1.0);
    const double radius = around - across * (1.0 - cosine(v));
    return Eigen::Vector3d(radius * sine(u), across * sine(v), radius * cosine(u));
  });
  place_with_unit_edges(mesh);
  return mesh;
}

Mesh make_freeform(int size) {
  // The profiles are 2.9 and 1.95 long: points in that proportion give edges of one length.
  const int columns = std::max(3, static_cast<int>(size * 1.22 + 0.5));
  const int rows = std::max(3, static_cast<int>(static_cast<double>(size) * size / columns + 0.5));
  const Eigen::Vector3d view(0.14, -0.11, 0.10);
  Mesh mesh = make_grid(columns, rows, [&](int i, int j) {
    const double s = 2.0 * i / (columns - 1) - 1.0, t = 2.0 * j / (rows - 1) - 1.0;
    const Eigen::Vector3d point = long_profile(s) + cross_profile(t);
    return Eigen::Vector3d(point / (1.0 + view.dot(point)));
  });
  place_with_unit_edges(mesh);
  return mesh;
}

}  // namespace planish
