// SPDX-License-Identifier: MIT
#include "supports/surface_sites.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// Places around a panel, as many edges above it.
std::vector<Eigen::Vector3d> places_at(const Mesh& mesh, int panel, double height) {
  std::vector<Eigen::Vector3d> places;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  const auto face = mesh.face(panel);
  for (const int v : face) middle += mesh.positions.col(v) / static_cast<double>(face.size());
  for (const int v : face) {
    const Eigen::Vector3d corner = mesh.positions.col(v);
    places.emplace_back(0.7 * middle + 0.3 * corner + Eigen::Vector3d(0.0, 0.0, height));
  }
  return places;
}

TEST(SurfaceSites, HaveTheDerivativesThatTheyReturn) {
  constexpr double kStep = 1e-5;
  for (const char* name : {"roof", "dome", "hex", "trihex"}) {
    const Mesh mesh = testing::sample(name, 12);
    const SurfaceSites sites(mesh);
    for (int f = 0; f < mesh.face_count(); f += 7) {
      for (const Eigen::Vector3d& p : places_at(mesh, f, 0.1)) {
        const SurfaceHeight here = sites.height(f, p);
        for (int axis = 0; axis < 3; ++axis) {
          const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
          const SurfaceHeight ahead = sites.height(f, p + step), behind = sites.height(f, p - step);
          EXPECT_NEAR((ahead.value - behind.value) / (2.0 * kStep), here.gradient[axis], 1e-8);
          const Eigen::Vector3d turn = (ahead.gradient - behind.gradient) / (2.0 * kStep);
          EXPECT_LE((turn - here.curvature.col(axis)).norm(), 1e-7) << name << " panel " << f;
        }
      }
    }
  }
}

TEST(SurfaceSites, OfAPlaneAreThatPlane) {
  const Mesh mesh = testing::quad_grid(6, 5);
  const SurfaceSites sites(mesh);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const Eigen::Vector3d& p : places_at(mesh, f, 0.3)) {
      const SurfaceHeight here = sites.height(f, p);
      EXPECT_NEAR(std::abs(here.value), 0.3, 1e-14);
      EXPECT_LE(here.curvature.norm(), 1e-13);
      EXPECT_EQ(sites.side(f), sites.side(0));
    }
  }
}

/// Of radius 10, panels of side 1: the height is the distance from it, to third order.
TEST(SurfaceSites, OfASphereAreNearIt) {
  Mesh mesh = testing::quad_grid(8, 8);
  for (auto point : mesh.positions.colwise()) {
    const double x = point[0] - 4.0, y = point[1] - 4.0;
    point = Eigen::Vector3d(x, y, std::sqrt(100.0 - x * x - y * y));
  }
  const SurfaceSites sites(mesh);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const Eigen::Vector3d& p : places_at(mesh, f, 0.0)) {
      const SurfaceHeight here = sites.height(f, p);
      EXPECT_NEAR(here.value, p.norm() - 10.0, 2e-3);
      EXPECT_LE((here.gradient - p.normalized()).norm(), 0.01);
    }
  }
}

TEST(SurfaceSites, EndAtSharpEdges) {
  const Mesh mesh = testing::make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
  const SurfaceSites sites(mesh);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int g = 0; g < f; ++g) EXPECT_NE(sites.side(f), sites.side(g));
    for (const Eigen::Vector3d& p : places_at(mesh, f, 0.0)) {
      EXPECT_NEAR(sites.height(f, p).value, 0.0, 1e-15);
    }
  }
}

}  // namespace
}  // namespace planish
