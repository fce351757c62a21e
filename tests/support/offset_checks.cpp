// SPDX-License-Identifier: MIT
#include "support/offset_checks.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "support/mesh_builders.hpp"

namespace planish::testing {
namespace {

/// Point j of ring i is at radius(j), height(j); `closed`: the last ring of points meets the first.
template <class Profile>
Mesh revolve(int around, int points, bool closed, const Profile& profile) {
  std::vector<Eigen::Vector3d> positions;
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < around; ++i) {
    const double t = 2.0 * std::numbers::pi * i / around;
    for (int j = 0; j < points; ++j) {
      const auto [radius, height] = profile(j);
      positions.emplace_back(radius * std::cos(t), radius * std::sin(t), height);
    }
  }
  const auto vertex = [&](int i, int j) { return (i % around) * points + j % points; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j + (closed ? 0 : 1) < points; ++j) {
      faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return make_mesh(positions, faces);
}

}  // namespace

MeshOffset offset_of(const Mesh& mesh, double distance, std::optional<OffsetKind> kind) {
  auto result = offset_mesh(mesh, {distance, kind});
  if (const auto* why = std::get_if<std::string>(&result)) {
    ADD_FAILURE() << *why;
    MeshOffset none;
    none.axes = Positions::Zero(3, mesh.vertex_count());
    none.positions = mesh.positions;
    return none;
  }
  return std::get<MeshOffset>(std::move(result));
}

std::string refusal(const Mesh& mesh, std::optional<OffsetKind> kind) {
  const auto result = offset_mesh(mesh, {0.1, kind});
  const auto* why = std::get_if<std::string>(&result);
  return why != nullptr ? *why : "";
}

double worst_angle(const Mesh& mesh, const Positions& after) {
  double worst = 0.0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k];
      const int b = face[(k + 1) % face.size()];
      const Eigen::Vector3d here = (mesh.positions.col(b) - mesh.positions.col(a)).normalized();
      const Eigen::Vector3d there = (after.col(b) - after.col(a)).normalized();
      worst = std::max(worst, here.cross(there).norm());
    }
  }
  return worst;
}

double worst_plane(const Mesh& mesh, const Positions& after, double distance) {
  double worst = 0.0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const Eigen::Vector3d a = mesh.positions.col(face[k]) - mesh.positions.col(face[0]);
      const Eigen::Vector3d b = mesh.positions.col(face[k + 1]) - mesh.positions.col(face[0]);
      area += a.cross(b);
    }
    // Every corner there against every corner here.
    for (const int there : face) {
      for (const int here : face) {
        const double apart = area.normalized().dot(after.col(there) - mesh.positions.col(here));
        worst = std::max(worst, std::abs(apart - distance));
      }
    }
  }
  return worst;
}

double worst_point(const Mesh& mesh, const Positions& after, double distance) {
  const Eigen::RowVectorXd lengths = (after - mesh.positions).colwise().norm();
  return (lengths.array() - std::abs(distance)).abs().maxCoeff();
}

Mesh torus(int around, int across) {
  return revolve(around, across, true, [across](int j) {
    const double t = 2.0 * std::numbers::pi * j / across;
    return std::pair(3.0 + std::cos(t), std::sin(t));
  });
}

Mesh vase(int around, int rings) {
  return revolve(around, rings + 1, false, [](int j) {
    return std::pair(2.0 + 0.3 * std::sin(0.9 * j) + 0.05 * j, 0.7 * j);
  });
}

Mesh cube() {
  return make_mesh(
      {{-1, -1, -1},
       {1, -1, -1},
       {1, 1, -1},
       {-1, 1, -1},
       {-1, -1, 1},
       {1, -1, 1},
       {1, 1, 1},
       {-1, 1, 1}},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

}  // namespace planish::testing
