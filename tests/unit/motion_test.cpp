// SPDX-License-Identifier: MIT
#include "planish/measures/motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "planish/mesh/area_vector.hpp"
#include "planish/numeric/index.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The motion of one vertex that goes by `move`.
PointMotion motion_of(const Mesh& mesh, int vertex, const Eigen::Vector3d& move) {
  Positions after = mesh.positions;
  after.col(vertex) += move;
  return motions(mesh, build_adjacency(mesh), std::vector<int>{vertex}, after).front();
}

void expect_motion(const PointMotion& motion, double shape, double slide) {
  EXPECT_NEAR(motion.shape, shape, 1e-12);
  EXPECT_NEAR(motion.slide, slide, 1e-12);
}

/// Nine rows of 20 panels on a circle of radius 10 about y, 6° each; both ways: a belt of the
/// sphere.
Mesh bent_grid(bool both_ways) {
  constexpr double kRadius = 10.0, kStep = kPi / 30.0;
  Mesh mesh = testing::quad_grid(21, 9);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double around = kStep * (mesh.positions(0, v) - 10.0);
    const double up = both_ways ? kStep * (mesh.positions(1, v) - 4.0) : 0.0;
    const double height = both_ways ? kRadius * std::sin(up) : mesh.positions(1, v);
    mesh.positions.col(v) = Eigen::Vector3d(kRadius * std::cos(up) * std::sin(around), height,
                                            kRadius * std::cos(up) * std::cos(around));
  }
  return mesh;
}

constexpr int kMiddle = 4 * 21 + 10;  ///< of that grid

TEST(Motion, OnAPlaneIsTheHeightAndTheWayAlongIt) {
  const Mesh mesh = testing::quad_grid(6, 6);
  for (const int v : {14, 21}) {  // within
    expect_motion(motion_of(mesh, v, {0.0, 0.0, 0.7}), 0.7, 0.0);
    expect_motion(motion_of(mesh, v, {0.0, 0.0, -0.7}), -0.7, 0.0);
    expect_motion(motion_of(mesh, v, {1.2, -0.9, 0.0}), 0.0, 1.5);
    expect_motion(motion_of(mesh, v, {0.3, 0.4, 2.0}), 2.0, 0.5);
  }
}

TEST(Motion, GoesOnStraightBeyondTheBorder) {
  const Mesh mesh = testing::quad_grid(4, 4);
  expect_motion(motion_of(mesh, 0, {-1.0, -1.0, 0.0}), 0.0, std::sqrt(2.0));
  expect_motion(motion_of(mesh, 0, {-3.0, 0.0, 4.0}), 4.0, 3.0);
  expect_motion(motion_of(mesh, 1, {0.4, -2.0, -0.5}), -0.5, std::hypot(0.4, 2.0));
  expect_motion(motion_of(mesh, 5, {0.0, -3.0, 0.1}), 0.1, 3.0);  // from within, over the border
}

TEST(Motion, AlongTheNormalOfADomeIsNoSlide) {
  for (const bool both_ways : {false, true}) {
    const Mesh mesh = bent_grid(both_ways);
    const Eigen::Vector3d out =
        mesh.positions.col(kMiddle).cwiseProduct(Eigen::Vector3d(1.0, both_ways ? 1.0 : 0.0, 1.0));
    expect_motion(motion_of(mesh, kMiddle, 0.05 * out), 0.05 * out.norm(), 0.0);
    const PointMotion pressed = motion_of(mesh, kMiddle, -0.05 * out);
    // The panels beside it are nearer than it: by the cosine of their angle to the normal, 3° a
    // way.
    EXPECT_LT(pressed.shape, -0.995 * 0.05 * out.norm());
    EXPECT_GT(pressed.shape, -0.05 * out.norm());
    EXPECT_NEAR(pressed.slide, 0.0, 1e-12);
  }
}

/// A point on a panel is on the old surface, however far it went; of one that follows the circle,
/// it is off by a panel's sag, r (1 − cos 3°) one way, twice that both ways.
TEST(Motion, AlongADomeIsNoChangeOfShape) {
  for (const bool both_ways : {false, true}) {
    const Mesh mesh = bent_grid(both_ways);
    const Eigen::Vector3d start = mesh.positions.col(kMiddle);
    for (const int corner : {kMiddle + 1, kMiddle + 22, kMiddle + 45, kMiddle - 3}) {
      const Eigen::Vector3d place =
          0.3 * mesh.positions.col(corner) + 0.7 * mesh.positions.col(corner + 1);
      const Eigen::Vector3d out =
          start.cwiseProduct(Eigen::Vector3d(1.0, both_ways ? 1.0 : 0.0, 1.0)).normalized();
      expect_motion(motion_of(mesh, kMiddle, place - start), 0.0,
                    (place - start).cross(out).norm());
    }
    for (const double angle : {0.02, 0.05, 0.3}) {
      const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitY());
      const PointMotion motion = motion_of(mesh, kMiddle, turn * start - start);
      EXPECT_GE(motion.shape, -1e-12);
      EXPECT_LE(motion.shape, (both_ways ? 2.0 : 1.0) * 10.0 * (1.0 - std::cos(kPi / 60.0)));
      EXPECT_NEAR(motion.slide, 10.0 * std::sin(angle), 1e-12);
    }
  }
}

TEST(Motion, OverAConcavePanelKeepsToItsOutline) {
  // An L of six corners; what is missing of the square is open.
  const Mesh mesh = testing::make_mesh(
      {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4, 5}});
  expect_motion(motion_of(mesh, 0, {0.5, 1.5, 0.4}), 0.4, std::hypot(0.5, 1.5));
  expect_motion(motion_of(mesh, 3, {0.5, 0.5, 0.3}), 0.3, std::sqrt(0.5));  // over the notch
  expect_motion(motion_of(mesh, 3, {-0.5, -0.5, -0.3}), -0.3, std::sqrt(0.5));
}

/// Two sheets 0.3 apart: from one, a place beyond the other is 1 off, not 0.7.
TEST(Motion, DoesNotJumpOntoASheetBehind) {
  Mesh mesh = testing::quad_grid(5, 5);
  const int count = mesh.vertex_count();
  Mesh second = mesh;
  second.positions.row(2).setConstant(0.3);
  mesh.positions.conservativeResize(3, 2 * count);
  mesh.positions.rightCols(count) = second.positions;
  const auto corners = second.face_vertices;
  for (const int v : corners) mesh.face_vertices.push_back(v + count);
  for (int f = 0; f < second.face_count(); ++f) {
    mesh.face_offsets.push_back(mesh.face_offsets.back() + 4);
  }
  expect_motion(motion_of(mesh, 12, {0.2, 0.0, 1.0}), 1.0, 0.2);
}

TEST(Motion, IsToldByItsLargest) {
  const std::vector<PointMotion> three = {{0.5, 0.1}, {-0.7, 0.2}, {0.0, 0.4}};
  const MotionRange range = range_of(three);
  EXPECT_EQ(range.raised, 0.5);
  EXPECT_EQ(range.lowered, 0.7);
  EXPECT_EQ(range.shape(), 0.7);
  EXPECT_EQ(range.slide, 0.4);
  EXPECT_EQ(range_of({}).shape(), 0.0);
}

/// Samples of all kinds of panels, each point moved by a random way of about `share` mean edges.
struct MovedSample {
  std::string name;
  Mesh mesh;
  Positions after;
  std::vector<int> all;
};

std::vector<MovedSample> moved_samples(double share) {
  std::vector<MovedSample> found;
  for (const unsigned seed : testing::seeds()) {
    for (const char* const name : {"roof", "vault", "dome", "freeform", "hex", "trihex"}) {
      MovedSample one{name, testing::sample(name, 8), {}, {}};
      const double edge = mean_edge_length(one.mesh);
      one.all.resize(static_cast<std::size_t>(one.mesh.vertex_count()));
      std::iota(one.all.begin(), one.all.end(), 0);
      one.after =
          one.mesh.positions + share * edge * testing::random_points(seed, one.mesh.vertex_count());
      found.push_back(std::move(one));
    }
  }
  return found;
}

std::vector<PointMotion> motions_in(const MovedSample& one) {
  return motions(one.mesh, build_adjacency(one.mesh), one.all, one.after);
}

TEST(MotionOfSamples, KeepsTheBoundsThatItStates) {
  for (const double share : {0.01, 0.5, 3.0}) {
    for (const MovedSample& one : moved_samples(share)) {
      const auto found = motions_in(one);
      for (const int v : one.all) {
        const auto [shape, slide] = found[static_cast<std::size_t>(v)];
        const double move = (one.after.col(v) - one.mesh.positions.col(v)).norm();
        const double rounding = 1e-9 * mean_edge_length(one.mesh);
        EXPECT_LE(std::abs(shape), move + rounding) << one.name << v;
        EXPECT_LE(slide, move + rounding) << one.name << v;
      }
    }
  }
}

/// From all panels, by triangles: they are convex and flat.
double distance_from_all(const Mesh& mesh, const Eigen::Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Eigen::Vector3d normal = area_vector(mesh.positions, face).normalized();
    const Eigen::Vector3d p = point - mesh.positions.col(face[0]);
    bool over = true;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Eigen::Vector3d a = mesh.positions.col(face[k]);
      const Eigen::Vector3d edge = mesh.positions.col(face[(k + 1) % face.size()]) - a;
      over = over && normal.dot(edge.cross(point - a)) >= 0.0;
      const double share = std::clamp(edge.dot(point - a) / edge.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (a + share * edge - point).norm());
    }
    if (over) least = std::min(least, std::abs(normal.dot(p)));
  }
  return least;
}

TEST(MotionOfSamples, IsTheDistanceFromAllPanelsForAShortMove) {
  for (const MovedSample& one : moved_samples(0.1)) {
    const Adjacency adjacency = build_adjacency(one.mesh);
    const auto found = motions_in(one);
    for (const int v : one.all) {
      const double nearest = distance_from_all(one.mesh, one.after.col(v));
      const double shape = std::abs(found[static_cast<std::size_t>(v)].shape);
      const double rounding = 1e-9 * mean_edge_length(one.mesh);
      if (adjacency.boundary[static_cast<std::size_t>(v)] != 0) {
        EXPECT_LE(shape, nearest + rounding) << one.name << v;  // it may be beside the surface
      } else {
        EXPECT_NEAR(shape, nearest, rounding) << one.name << v;
      }
    }
  }
}

TEST(MotionOfSamples, TurnsItsSignWithThePanelsAndGrowsWithTheUnit) {
  for (const MovedSample& one : moved_samples(0.4)) {
    MovedSample other = one;
    for (int f = 0; f < other.mesh.face_count(); ++f) {
      std::reverse(other.mesh.face_vertices.begin() + other.mesh.face_offsets[at(f)],
                   other.mesh.face_vertices.begin() + other.mesh.face_offsets[at(f + 1)]);
    }
    other.mesh.positions *= 1024.0;
    other.after *= 1024.0;
    const auto found = motions_in(one), turned = motions_in(other);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const double rounding = 1e-9 * mean_edge_length(one.mesh);
      EXPECT_NEAR(turned[k].shape / 1024.0, -found[k].shape, rounding) << one.name << k;
      EXPECT_NEAR(turned[k].slide / 1024.0, found[k].slide, rounding) << one.name << k;
    }
  }
}

TEST(MotionOfSamples, IsTheSameWhoeverElseMoves) {
  for (const MovedSample& one : moved_samples(0.4)) {
    const auto found = motions_in(one);
    const auto last = motions(one.mesh, build_adjacency(one.mesh),
                              std::vector<int>{one.mesh.vertex_count() - 1}, one.after);
    EXPECT_EQ(last.front().shape, found.back().shape) << one.name;
    EXPECT_EQ(last.front().slide, found.back().slide) << one.name;
  }
}

}  // namespace
}  // namespace planish
