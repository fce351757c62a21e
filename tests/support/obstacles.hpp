// SPDX-License-Identifier: MIT
/// What stands in the way of random edits, and how deep an edit went into it: measured without the
/// core's rows.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish::testing {

/// Nothing may be where normal · p > most.
struct Plane {
  Eigen::Vector3d normal;
  double most;

  [[nodiscard]] double beyond(const Eigen::Vector3d& p) const { return normal.dot(p) - most; }
  /// As --keep-out says it.
  [[nodiscard]] std::string text() const;
};

/// By how many mean edges moved points are deeper than they may be.
[[nodiscard]] double deepest(const Mesh& mesh, const HandleEditResult& result, const Plane& plane,
                             double clearance = 0.0);

/// A sample of 16, or a shared mesh made flat; no faces where it is absent.
[[nodiscard]] Mesh obstructed_mesh(const std::string& name);

/// Names for obstructed_mesh().
inline constexpr std::array kObstructedMeshes = {"roof",        "vault",
                                                 "dome",        "freeform",
                                                 "hex",         "trihex",
                                                 "pq_gitter",   "mixed345_airport",
                                                 "pq_octtorus", "hex_sphere_two_openings"};

/// Tests on one of them.
class OnObstructedMesh : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    mesh = obstructed_mesh(GetParam());
    if (mesh.face_count() == 0) GTEST_SKIP() << "no shared meshes here";
  }

  Mesh mesh;
};

/// A pull at one vertex and a plane in its way.
struct Obstacle {
  int vertex = 0;
  Eigen::Vector3d move;
  Plane plane;
};

/// Pulls of about a mean edge at random points, and planes at right angles to them: half of them
/// begin beyond the handle, a quarter in the middle of points that are inside already, a quarter go
/// through the handle itself.
[[nodiscard]] std::vector<Obstacle> obstacles(const Mesh& mesh, unsigned seed, int count);

/// A box with sides along the axes.
struct Box {
  Eigen::Vector3d low, high;

  /// As --keep-out says it.
  [[nodiscard]] std::string text() const;
  /// The same as a model of its six sides.
  [[nodiscard]] std::string model_text() const;
};

/// By how many mean edges touched panels are nearer to the box than they may be: than the
/// clearance, or than the axis that parted them best in the base, if that was nearer.
[[nodiscard]] double worst_entry(const Mesh& mesh, const HandleEditResult& result, const Box& box,
                                 double clearance);

/// Pulls at random points of 0.5 to 1.3 mean edges, and boxes of 0.2 to 1 mean edges half-way, that
/// no panel meets in the base.
struct BoxInTheWay {
  int vertex = 0;
  Eigen::Vector3d move;
  Box box;
};

[[nodiscard]] std::vector<BoxInTheWay> boxes_near(const Mesh& mesh, unsigned seed, int count);

}  // namespace planish::testing
