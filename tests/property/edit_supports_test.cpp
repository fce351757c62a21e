// SPDX-License-Identifier: MIT
/// What supports hold: points slide on what they stand on and never leave it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/adjacency.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"
#include "support/supported_edit.hpp"

namespace planish {
namespace {

using testing::support;

std::string numbers(const Eigen::VectorXd& values) {
  std::string text;
  for (const double value : values) {
    char one[40];
    std::snprintf(one, sizeof one, "%s%.17g", text.empty() ? "" : ",", value);
    text += one;
  }
  return text;
}

/// A plane through a vertex.
PointSupport plane_through(const Mesh& mesh, int vertex, const Eigen::Vector3d& normal) {
  Eigen::Vector4d plane;
  plane << normal, normal.dot(mesh.positions.col(vertex));
  return support("plane=" + numbers(plane) + ":" + std::to_string(vertex));
}

PointSupport line_through(const Mesh& mesh, int vertex, const Eigen::Vector3d& direction) {
  Eigen::VectorXd line(6);
  line << mesh.positions.col(vertex), direction;
  return support("line=" + numbers(line) + ":" + std::to_string(vertex));
}

class EditSupports : public testing::SupportedEdit {};

TEST_P(EditSupports, ALevelKeepsTheCoordinatesBits) {
  for (const int axis : {0, 1, 2}) {
    for (const char* points : {"boundary", "all"}) {
      EditTargets targets = lifted(0.6);
      const int rim = boundary_vertices(mesh)[5];
      targets.handles.push_back({rim, mesh.positions.col(rim) + Eigen::Vector3d(0.3, 0.2, 0.1)});
      targets.supports = {support(std::string("level=") + "xyz"[axis] + ":" + points)};
      const HandleEditResult result = solve(targets);
      const Positions after = apply(mesh, result);
      for (const int v : points_of(targets.supports.front(), mesh)) {
        EXPECT_EQ(after(axis, v), mesh.positions(axis, v)) << points << " vertex " << v;
      }
      EXPECT_GT(result.report.moved_vertices, 0);
    }
  }
}

TEST_P(EditSupports, PointsStayOnTheirPlanesAndLines) {
  const double edge = mean_edge_length(mesh);
  for (const bool lines : {false, true}) {
    EditTargets targets = lifted(0.6);
    int k = 0;
    for (const int v : around()) {
      const Eigen::Vector3d direction(1.0, 0.3 * ++k, 0.5);
      targets.supports.push_back(lines ? line_through(mesh, v, direction)
                                       : plane_through(mesh, v, direction));
    }
    const HandleEditResult result = solve(targets);
    const Positions after = apply(mesh, result);
    double slid = 0.0;
    for (const PointSupport& one : targets.supports) {
      EXPECT_LE(largest_distance(one, mesh, after), 1e-9 * edge) << point_support_text(one);
      const int v = one.vertices.front();
      slid = std::max(slid, (after.col(v) - mesh.positions.col(v)).norm());
    }
    EXPECT_GT(slid, 1e-3 * edge) << "they slide";
  }
}

/// A support takes freedom away, a pin takes more.
TEST_P(EditSupports, CostMoreThanFreedomAndLessThanPins) {
  constexpr double kOtherBasin = 1.02;  // none of the three is convex
  const EditTargets free = lifted(0.3);
  EditTargets held = free, pinned = free;
  pinned.pins = around();
  for (const int v : around()) {
    held.supports.push_back(plane_through(mesh, v, {0.2, 0.1, 1.0}));
  }
  const double without = solve(free).report.objective.total();
  const double with = solve(held).report.objective.total();
  EXPECT_LE(without, kOtherBasin * with);
  EXPECT_LE(with, kOtherBasin * solve(pinned).report.objective.total());
  EXPECT_GT(with, 1.01 * without) << "the supports are felt";
}

TEST_P(EditSupports, ConvergedIsCertifiedAlongTheSupports) {
  int converged = 0;
  for (const double lift : {0.2, 0.5, 1.0}) {
    EditTargets targets = lifted(lift);
    for (const int v : around()) {
      targets.supports.push_back(plane_through(mesh, v, {0.2, 0.1, 1.0}));
    }
    const HandleEditResult result = solve(targets);
    if (result.report.status != SolveStatus::kConverged) continue;
    ++converged;
    ASSERT_TRUE(result.report.optimality.has_value());
    EXPECT_TRUE(result.report.optimality->met());
  }
  EXPECT_GE(converged, 2);
}

TEST_P(EditSupports, HoldInEveryFrameOfADrag) {
  constexpr int kFrames = 20;
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  HandleEditSolver solver(mesh, {});
  const double edge = mean_edge_length(mesh);
  for (int frame = 1; frame <= kFrames; ++frame) {
    EditTargets targets = lifted(0.04 * frame);
    targets.supports = {support("level:boundary")};
    for (const int v : around()) {
      targets.supports.push_back(plane_through(mesh, v, {0.2, 0.1, 1.0}));
    }
    const HandleEditResult result = solver.drag(targets, kBudget);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result)) << "frame " << frame;
    const Positions after = apply(mesh, result);
    EXPECT_EQ(largest_distance(targets.supports.front(), mesh, after), 0.0);
    for (const PointSupport& one : targets.supports) {
      EXPECT_LE(largest_distance(one, mesh, after), 1e-9 * edge) << "frame " << frame;
    }
  }
}

TEST_P(EditSupports, AHandleSlidesToThePointNearestItsTarget) {
  EditTargets targets = testing::pull(mesh, handle, {0.4, 0.0, 0.8});
  targets.supports = {support("level=z:" + std::to_string(handle))};
  const HandleEditResult result = solve(targets);
  const Eigen::Vector3d moved = apply(mesh, result).col(handle) - mesh.positions.col(handle);
  EXPECT_EQ(moved.z(), 0.0);
  EXPECT_NEAR(moved.x(), 0.4, 0.05);
}

TEST_P(EditSupports, AHardHandleThatWouldLeaveItsSupportIsInfeasible) {
  EditTargets targets = testing::pull(mesh, handle, {0.4, 0.0, 0.8});
  targets.supports = {support("level=z:" + std::to_string(handle))};
  HandleEditOptions options;
  options.hard_handles = true;
  const HandleEditResult result = solve_handle_edit(mesh, targets, options);
  EXPECT_EQ(result.report.status, SolveStatus::kInfeasibleHandles);
  EXPECT_EQ(largest_distance(targets.supports.front(), mesh, apply(mesh, result)), 0.0);
}

TEST_P(EditSupports, TwoOfAPointLeaveItWhatTheyShare) {
  EditTargets targets = testing::pull(mesh, handle, {0.4, 0.3, 0.8});
  const std::string vertex = std::to_string(handle);
  targets.supports = {support("level=z:" + vertex), support("level=x:" + vertex)};
  const Positions after = apply(mesh, solve(targets));
  EXPECT_EQ(after(0, handle), mesh.positions(0, handle));
  EXPECT_EQ(after(2, handle), mesh.positions(2, handle));
  EXPECT_NEAR(after(1, handle) - mesh.positions(1, handle), 0.3, 0.05);
  targets.supports.push_back(support("level=y:" + vertex));
  EXPECT_EQ(solve(targets).report.moved_vertices, 0) << "three leave it nothing";
}

TEST_P(EditSupports, NewOnesBeginANewDrag) {
  constexpr double kBudget = 10.0;
  HandleEditSolver solver(mesh, {});
  EditTargets targets = lifted(0.5);
  static_cast<void>(solver.drag(targets, kBudget));
  targets.supports = {support("level=z:all")};
  const Positions after = apply(mesh, solver.drag(targets, kBudget));
  EXPECT_EQ(after.row(2), mesh.positions.row(2));
}

INSTANTIATE_TEST_SUITE_P(Samples, EditSupports, ::testing::Values("roof", "dome", "hex", "trihex"),
                         &testing::sample_name);

}  // namespace
}  // namespace planish
