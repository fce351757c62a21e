// SPDX-License-Identifier: MIT
#include "cones.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/area_vector.hpp"
#include "support/singular_values.hpp"

namespace planish::testing {
namespace {

/// The angle between two edges in degrees, from the chord of their unit vectors.
double angle_between(const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  const double half = 0.5 * (first.normalized() - second.normalized()).norm();
  return 2.0 * std::asin(std::min(1.0, half)) * 180.0 / std::numbers::pi;
}

}  // namespace

double worst_cone_defect(const Mesh& mesh, const Positions& positions) {
  const Adjacency adjacency = build_adjacency(mesh);
  double worst = 0.0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto faces = adjacency.faces[v];
    if (adjacency.boundary[static_cast<std::size_t>(v)] != 0 || faces.size() != 4) continue;
    const auto first = mesh.face(faces[0]);
    double sum = 0.0;
    for (const int f : faces) {
      const auto face = mesh.face(f);
      const auto here = std::find(face.begin(), face.end(), v) - face.begin();
      const auto n = static_cast<std::ptrdiff_t>(face.size());
      const int next = face[static_cast<std::size_t>((here + 1) % n)];
      const int last = face[static_cast<std::size_t>((here + n - 1) % n)];
      const Eigen::Vector3d p = positions.col(v);
      const double angle = angle_between(positions.col(next) - p, positions.col(last) - p);
      const auto shared = std::count_if(face.begin(), face.end(), [&](int w) {
        return std::find(first.begin(), first.end(), w) != first.end();
      });
      sum += shared == 2 ? -angle : angle;
    }
    worst = std::max(worst, std::abs(sum));
  }
  return worst;
}

double axis_spread(const Mesh& mesh, const Positions& positions, int vertex) {
  const Adjacency adjacency = build_adjacency(mesh);
  const auto faces = adjacency.faces[vertex];
  Eigen::Matrix3Xd normals(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t k = 0; k < faces.size(); ++k) {
    normals.col(static_cast<Eigen::Index>(k)) =
        area_vector(positions, mesh.face(faces[k])).normalized();
  }
  const Eigen::Matrix3Xd centred = normals.colwise() - normals.rowwise().mean();
  const auto svd = singular_values(centred, Eigen::ComputeFullU);
  const Eigen::RowVectorXd along = svd.matrixU().col(2).transpose() * normals;
  const Eigen::ArrayXd angles = along.transpose().array().acos() * 180.0 / std::numbers::pi;
  return angles.maxCoeff() - angles.minCoeff();
}

Mesh sectors(int valence, int rings) {
  std::map<std::array<int, 3>, int>
      numbers;  // by sector, steps along its first side and its second
  std::vector<Eigen::Vector3d> points;
  const auto direction = [&](int sector) -> Eigen::Vector2d {
    const double angle = 2.0 * std::numbers::pi * sector / valence;
    return {std::cos(angle), std::sin(angle)};
  };
  const auto number = [&](int sector, int i, int j) {
    if (i == 0) {  // the second side is the next sector's first
      sector = j == 0 ? 0 : (sector + 1) % valence;
      std::swap(i, j);
    }
    const auto [entry, fresh] =
        numbers.emplace(std::array{sector, i, j}, static_cast<int>(points.size()));
    if (fresh) {
      const Eigen::Vector2d p = i * direction(sector) + j * direction(sector + 1);
      points.emplace_back(p.x(), p.y(), -0.06 * p.x() * p.x() - 0.03 * p.y() * p.y());
    }
    return entry->second;
  };
  Mesh mesh;
  (void)number(0, 0, 0);
  for (int sector = 0; sector < valence; ++sector) {
    for (int i = 0; i < rings; ++i) {
      for (int j = 0; j < rings; ++j) {
        for (const int v : {number(sector, i, j), number(sector, i + 1, j),
                            number(sector, i + 1, j + 1), number(sector, i, j + 1)}) {
          mesh.face_vertices.push_back(v);
        }
        mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
      }
    }
  }
  mesh.positions.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t v = 0; v < points.size(); ++v) {
    mesh.positions.col(static_cast<Eigen::Index>(v)) = points[v];
  }
  return mesh;
}

}  // namespace planish::testing
