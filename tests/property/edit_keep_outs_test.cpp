// SPDX-License-Identifier: MIT
/// What keep-outs hold: no point of an edit or of a drag goes beyond a plane, and what is beyond it
/// in the base goes no deeper, measured without the rows.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/edit/symmetric_edit.hpp"
#include "planish/variations/exact_variation.hpp"
#include "support/edit_invariants.hpp"
#include "support/mesh_builders.hpp"
#include "support/obstacles.hpp"
#include "support/scenes.hpp"
#include "support/symmetric_meshes.hpp"

namespace planish {
namespace {

using testing::deepest;
using testing::Obstacle;
using testing::obstacles;
using testing::Plane;

constexpr double kHeld = 1e-9;  ///< mean edges: what was promised

using EditKeepOuts = testing::OnObstructedMesh;

TEST_P(EditKeepOuts, NoPointGoesBeyondAPlane) {
  const int edits = testing::by_night(12, 4);
  int certified = 0, moved = 0, binding = 0;
  for (const Obstacle& one : obstacles(mesh, 41, edits)) {
    SCOPED_TRACE("vertex " + std::to_string(one.vertex) + " " + one.plane.text());
    HandleEditOptions options;
    options.keep_outs = {*parse_keep_out(one.plane.text())};
    const EditTargets targets = testing::pull(mesh, one.vertex, one.move);
    const HandleEditResult result = solve_handle_edit(mesh, targets, options);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    EXPECT_LE(deepest(mesh, result, one.plane), kHeld);
    ASSERT_EQ(result.report.bounds.size(), 1u);
    certified += result.report.status == SolveStatus::kConverged ? 1 : 0;
    moved += result.report.moved_vertices > 0 ? 1 : 0;
    binding += result.report.bounds.front().binding.empty() ? 0 : 1;
  }
  RecordProperty("certified", certified);
  std::printf("%s: %d certified, %d moved, %d binding of %d\n", GetParam(), certified, moved,
              binding, edits);
  EXPECT_GE(2 * moved, edits);
  EXPECT_GE(3 * certified, 2 * edits);
  EXPECT_GE(2 * binding, edits);
}

TEST_P(EditKeepOuts, NoFrameOfADragGoesBeyondAPlane) {
  constexpr int kFrames = 16;
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  for (const Obstacle& one : obstacles(mesh, 43, 4)) {
    SCOPED_TRACE("vertex " + std::to_string(one.vertex) + " " + one.plane.text());
    HandleEditOptions options;
    options.keep_outs = {*parse_keep_out(one.plane.text())};
    HandleEditSolver solver(mesh, options);
    int followed = 0;
    Positions last = mesh.positions;
    for (int frame = 1; frame <= kFrames; ++frame) {
      const auto targets = testing::pull(mesh, one.vertex, (1.5 * frame / kFrames) * one.move);
      const HandleEditResult result = solver.drag(targets, kBudget);
      EXPECT_LE(deepest(mesh, result, one.plane), kHeld) << "frame " << frame;
      EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
      followed += apply(mesh, result) != last ? 1 : 0;
      last = apply(mesh, result);
    }
    std::printf("%s %d: %d frames of %d\n", GetParam(), one.vertex, followed, kFrames);
    EXPECT_GE(followed, kFrames / 2);
  }
}

/// Whatever else an edit has to keep, it keeps keep-outs, too.
class EditKeepOutsBeside : public EditKeepOuts {
 protected:
  void SetUp() override {
    EditKeepOuts::SetUp();
    if (IsSkipped()) return;
    one = obstacles(mesh, 47, 4)[1];
    options.keep_outs = {*parse_keep_out(one.plane.text())};
    targets = testing::pull(mesh, one.vertex, one.move);
  }

  void expect_held() const {
    const HandleEditResult result = solve_handle_edit(mesh, targets, options);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    EXPECT_LE(deepest(mesh, result, one.plane, options.clearance), kHeld);
  }

  Obstacle one;
  HandleEditOptions options;
  EditTargets targets;
};

TEST_P(EditKeepOutsBeside, AReachHold) {
  options.reach = 4;
  options.softness = 5.0;
  options.keep_boundary = true;
  expect_held();
}

TEST_P(EditKeepOutsBeside, HardHandlesHold) {
  options.hard_handles = true;
  expect_held();
}

TEST_P(EditKeepOutsBeside, LimitsHold) {
  options.reach = 6;
  options.softness = 5.0;
  options.bounds = {*parse_stated_limit("fold=+5")};
  expect_held();
}

TEST_P(EditKeepOutsBeside, AClearanceHold) {
  options.clearance = 0.1 * mean_edge_length(mesh);
  options.sparsity = Sparsity::kL2;
  expect_held();
}

TEST_P(EditKeepOutsBeside, APinAndAContinuationHold) {
  for (const int v : testing::ring_neighbourhood(mesh, one.vertex, 1)) {
    if (v != one.vertex) targets.pins = {v};
  }
  targets.continuation = 4;
  expect_held();
}

/// Every night the slowest too, of which at a commit EditKeepOuts asks what it asks of all.
std::vector<const char*> held_beside() {
  std::vector<const char*> meshes(testing::kObstructedMeshes.begin(),
                                  testing::kObstructedMeshes.end());
  if (!testing::is_night()) {
    meshes.erase(std::find(meshes.begin(), meshes.end(), std::string("mixed345_airport")));
  }
  return meshes;
}

INSTANTIATE_TEST_SUITE_P(Meshes, EditKeepOutsBeside, ::testing::ValuesIn(held_beside()),
                         [](const auto& each) { return std::string(each.param); });

INSTANTIATE_TEST_SUITE_P(Meshes, EditKeepOuts, ::testing::ValuesIn(testing::kObstructedMeshes),
                         [](const auto& each) { return std::string(each.param); });

/// A floor that a whole mesh stands on: it lifts off as if there were none, and never sinks.
TEST(EditOnAFloor, LiftsOffFreelyAndNeverSinks) {
  const Mesh mesh = testing::quad_grid(13, 13);
  const int middle = 6 * 13 + 6;
  HandleEditOptions options;
  options.keep_outs = {*parse_keep_out("below=0")};
  const auto solve = [&](const HandleEditOptions& by, const Eigen::Vector3d& move) {
    const EditTargets targets = testing::pull(mesh, middle, move);
    HandleEditResult result = solve_handle_edit(mesh, targets, by);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    return result;
  };
  const HandleEditResult lifted = solve(options, {0.1, 0.0, 0.8});
  EXPECT_EQ(lifted.report.status, SolveStatus::kConverged);
  EXPECT_GT(lifted.report.moved_vertices, 4);
  EXPECT_LT(lifted.report.handle_error, 0.1);
  EXPECT_GE(apply(mesh, lifted).row(2).minCoeff(), -kHeld);
  const HandleEditResult sunk = solve(options, {0.3, 0.0, -0.8});
  EXPECT_EQ(sunk.report.status, SolveStatus::kConverged);
  EXPECT_GE(apply(mesh, sunk).row(2).minCoeff(), -kHeld);
  EXPECT_GT(sunk.report.moved_vertices, 0) << "it slides";
}

/// What rests is let go of again: a drag goes down, where nothing can follow, and comes up.
TEST(EditOnAFloor, ADragSinksNothingAndLiftsOffAgain) {
  const Mesh mesh = testing::quad_grid(11, 11);
  const int middle = 5 * 11 + 5;
  HandleEditOptions options;
  options.keep_outs = {*parse_keep_out("below=0")};
  HandleEditSolver solver(mesh, options);
  double last = 0.0;
  for (const double height : {-0.2, -0.6, -1.2, -0.5, 0.2, 0.5, 0.8}) {
    const HandleEditResult frame =
        solver.drag(testing::pull(mesh, middle, {0.2, 0.0, height}), 10.0);
    EXPECT_GE(apply(mesh, frame).row(2).minCoeff(), -kHeld) << height;
    last = frame.report.handle_error;
  }
  EXPECT_LT(last, 0.2);
}

/// The planes that hold a point push and never pull: with a plane that points are on, and away from
/// which they are pulled, the certified edit is the one without it.
TEST(EditOnAFloor, APlaneThatOnlyPushesChangesNothingBehindIt) {
  const Mesh mesh = testing::sample("dome", 16);
  const int handle = testing::middle_vertex(mesh);
  const EditTargets targets = testing::pull(mesh, handle, {0.0, 0.0, 0.5});
  const HandleEditResult free = solve_handle_edit(mesh, targets);
  const Positions after = apply(mesh, free);
  // Below everything that moved down, through a point that moved up.
  HandleEditOptions options;
  int through = -1;
  for (const int v : free.moved) {
    if (after(2, v) > mesh.positions(2, v) + 0.05) through = v;
  }
  ASSERT_GE(through, 0);
  char words[64];
  std::snprintf(words, sizeof words, "below=%.17g", mesh.positions(2, through));
  options.keep_outs = {*parse_keep_out(words)};
  const HandleEditResult held = solve_handle_edit(mesh, targets, options);
  ASSERT_EQ(held.report.status, SolveStatus::kConverged);
  for (const int v : held.moved) {
    const double lowest = std::min(mesh.positions(2, v), mesh.positions(2, through));
    EXPECT_GE(apply(mesh, held)(2, v), lowest - kHeld) << v;
  }
}

/// Supports and keep-outs on the same points.
TEST(EditOnAFloor, PointsSlideOnSupportsAlongAKeepOut) {
  const Mesh mesh = testing::sample("vault", 16);
  const int handle = testing::middle_vertex(mesh);
  for (const char* support : {"level=x:all", "outline:boundary"}) {
    EditTargets targets = testing::pull(mesh, handle, {0.3, 0.2, -0.6});
    targets.supports = {*parse_point_support(support)};
    HandleEditOptions options;
    char words[64];
    std::snprintf(words, sizeof words, "below=%.17g", mesh.positions(2, handle) - 0.1);
    options.keep_outs = {*parse_keep_out(words), *parse_keep_out("below=0")};
    const HandleEditResult result = solve_handle_edit(mesh, targets, options);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    const Plane floor{{0, 0, -1}, 0.1 - mesh.positions(2, handle)}, ground{{0, 0, -1}, 0.0};
    EXPECT_LE(deepest(mesh, result, floor), kHeld) << support;
    EXPECT_LE(deepest(mesh, result, ground), kHeld) << support;
    EXPECT_LE(largest_distance(targets.supports[0], mesh, apply(mesh, result)), 1e-9) << support;
  }
}

/// Where the mesh is does not matter.
TEST(EditKeepOutsFarAway, HoldToWhatCoordinatesCanSay) {
  Mesh mesh = testing::sample("vault", 16);
  mesh.positions.colwise() += Eigen::Vector3d(512345.25, 5398765.5, 430.0);
  for (const Obstacle& one : obstacles(mesh, 53, 4)) {
    HandleEditOptions options;
    options.keep_outs = {*parse_keep_out(one.plane.text())};
    const EditTargets targets = testing::pull(mesh, one.vertex, one.move);
    const HandleEditResult result = solve_handle_edit(mesh, targets, options);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    EXPECT_LE(deepest(mesh, result, one.plane), 1e-8);
    EXPECT_GT(result.report.moved_vertices, 0);
  }
}

/// A keep-out that is on one side holds on all: the result is symmetric.
TEST(SymmetricKeepOuts, HoldWithTheirImages) {
  const Mesh mesh = testing::sample("vault", 16);
  const MeshSymmetry symmetry = testing::symmetry_of(mesh, "x");
  const int vertex = 5 * 16 + 5;
  const Plane wall{Eigen::Vector3d(-1.0, 0.2, 0.3).normalized(), 0.0};
  Plane through = wall;
  through.most = wall.normal.dot(mesh.positions.col(vertex)) + 0.15;
  const auto all = with_images(testing::pull(mesh, vertex, {-0.4, 0.1, 0.3}), mesh, symmetry);
  const EditTargets targets = std::get<EditTargets>(all);
  HandleEditOptions options;
  options.keep_outs = {*parse_keep_out(through.text())};
  HandleEditSolver solver(mesh, options);
  const HandleEditResult result = solver.solve_symmetric(targets, symmetry);
  EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
  EXPECT_GT(result.report.moved_vertices, 0);
  EXPECT_LE(asymmetry(symmetry, mesh, apply(mesh, result)), kHeld);
  EXPECT_LE(deepest(mesh, result, through), kHeld);
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
}

/// Variations made exact keep what the edit keeps.
TEST(KeptOutVariations, MadeExactKeepOut) {
  const Mesh mesh = testing::sample("vault", 16);
  const int handle = testing::middle_vertex(mesh);
  const EditTargets targets = testing::pull(mesh, handle, {0.0, 0.0, 0.6});
  const Positions edited = apply(mesh, solve_handle_edit(mesh, targets));
  SubspaceOptions family;
  family.dimension = 2;
  const Subspace subspace = compute_subspace(mesh, edited, {}, family);
  int stopped = 0;
  for (const double slider : {-2.0, -1.0, 1.0, 2.0}) {
    const Eigen::Vector2d values(slider, -0.5 * slider);
    const Positions shown = testing::varied(edited, subspace, values);
    const double top = edited.row(2).maxCoeff(), wanted = shown.row(2).maxCoeff();
    const Plane ceiling{{0.0, 0.0, 1.0}, top + 0.3 * std::max(0.1, wanted - top)};
    HandleEditOptions options;
    options.keep_outs = {*parse_keep_out(ceiling.text())};
    const auto keeps = kept_by_variations(mesh, targets, options);
    const ProjectionResult exact = make_exact({mesh, edited, shown}, options, 0.0, keeps);
    Positions shape = shown;
    shape(Eigen::all, exact.moved) = exact.moved_positions;
    EXPECT_LE(shape.row(2).maxCoeff(), ceiling.most + kHeld) << slider;
    if (wanted <= ceiling.most) continue;
    ++stopped;
    EXPECT_EQ(exact.report.status, SolveStatus::kNearestConfined);
    ASSERT_FALSE(exact.report.bounds.empty());
    EXPECT_EQ(exact.report.bounds.front().name, "keep-out");
    EXPECT_FALSE(exact.report.bounds.front().binding.empty());
  }
  EXPECT_GT(stopped, 0) << "some variation would go beyond it";
}

/// What rests on a keep-out stays in variations where the edit put it.
TEST(KeptOutVariations, LeaveWhatRests) {
  const Mesh mesh = testing::quad_grid(9, 9);
  HandleEditOptions options;
  options.keep_outs = {*parse_keep_out("below=0"), *parse_keep_out("plane=1,0,0,7.5")};
  EXPECT_EQ(kept_by_variations(mesh, {}, options).held.size(), 81u);
  options.keep_outs.erase(options.keep_outs.begin());
  EXPECT_EQ(kept_by_variations(mesh, {}, options).held.size(), 9u) << "the last column";
}

}  // namespace
}  // namespace planish
