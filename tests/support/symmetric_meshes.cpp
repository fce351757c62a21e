// SPDX-License-Identifier: MIT
#include "support/symmetric_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace planish::testing {
namespace {

template <class Motion>
double distance_to_itself(const Positions& positions, const Motion& motion) {
  double largest = 0.0;
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    const Eigen::Vector3d image = motion(Eigen::Vector3d(positions.col(v)));
    largest = std::max(largest, (positions.colwise() - image).colwise().norm().minCoeff());
  }
  return largest;
}

}  // namespace

Mesh turned_surface(int sides, int rings, const Eigen::Vector3d& centre, double angle) {
  Mesh mesh;
  mesh.positions.resize(3, static_cast<Eigen::Index>(sides) * rings);
  for (int r = 0; r < rings; ++r) {
    const double share = static_cast<double>(r) / rings;
    const double radius = sides / 6.0 * (1.0 + 0.4 * std::sin(2.0 * share));
    for (int k = 0; k < sides; ++k) {
      const double turn = angle + 2.0 * std::numbers::pi * k / sides;
      mesh.positions.col(static_cast<Eigen::Index>(r) * sides + k) =
          centre + Eigen::Vector3d(radius * std::cos(turn), radius * std::sin(turn), r);
      if (r + 1 == rings) continue;
      const int a = r * sides + k, b = r * sides + (k + 1) % sides;
      mesh.face_vertices.insert(mesh.face_vertices.end(), {a, b, b + sides, a + sides});
      mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
    }
  }
  return mesh;
}

MeshSymmetry symmetry_of(const Mesh& mesh, const std::string& text) {
  const auto stated = parse_symmetry(text);
  EXPECT_TRUE(stated) << text;
  auto found = find_symmetry(mesh, stated.value_or(StatedSymmetry{}));
  const auto* problem = std::get_if<std::string>(&found);
  EXPECT_EQ(problem, nullptr) << *problem;
  return problem ? MeshSymmetry{} : std::get<MeshSymmetry>(std::move(found));
}

double mirror_error(const Positions& positions, int axis, double at) {
  return distance_to_itself(positions, [&](Eigen::Vector3d p) {
    p[axis] = 2.0 * at - p[axis];
    return p;
  });
}

double turn_error(const Positions& positions, int order, const Eigen::Vector3d& centre) {
  const double angle = 2.0 * std::numbers::pi / order;
  return distance_to_itself(positions, [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = p - centre;
    return Eigen::Vector3d(centre.x() + std::cos(angle) * q.x() - std::sin(angle) * q.y(),
                           centre.y() + std::sin(angle) * q.x() + std::cos(angle) * q.y(), p.z());
  });
}

bool is_mirrored_to_the_bit(const Positions& positions, int axis, double at) {
  std::set<std::array<double, 3>> known;
  for (const auto& p : positions.colwise()) known.insert({p.x(), p.y(), p.z()});
  return std::all_of(known.begin(), known.end(), [&](std::array<double, 3> p) {
    p[static_cast<std::size_t>(axis)] = 2.0 * at - p[static_cast<std::size_t>(axis)];
    return known.count(p) == 1;
  });
}

}  // namespace planish::testing
