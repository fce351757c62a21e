// SPDX-License-Identifier: MIT
/// Edits that keep panels circular: what the constraint promises, measured without its code.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/projection/projection.hpp"
#include "support/circles.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kCircular = 1e-9;  ///< degrees

HandleEditOptions circular() {
  HandleEditOptions options;
  options.constraints = {{"circular", kCircular}};
  return options;
}

/// Flat, circular, sound, and everything that is not reported as moved bit-identical.
void expect_kept(const Mesh& mesh, const HandleEditResult& result) {
  const Positions after = apply(mesh, result);
  EXPECT_LE(testing::inscribed_defect(mesh, after), kCircular);
  EXPECT_LE(planarity_summary(mesh, after).max, testing::kPromise);
  for (int f = 0; f < mesh.face_count(); ++f) {
    EXPECT_EQ(panel_damage(mesh.positions, after, mesh.face(f)), PanelDamage::kNone) << f;
  }
  EXPECT_EQ(moved_vertex_count(mesh.positions, after), static_cast<int>(result.moved.size()));
}

const KindViolation& circular_violation(const HandleEditResult& result) {
  EXPECT_EQ(result.report.violations.size(), 2u);
  EXPECT_EQ(result.report.violations.front().kind, "planar");
  EXPECT_EQ(result.report.violations.back().kind, "circular");
  return result.report.violations.back();
}

/// The two edits of issue 12, with the objectives of the prototype as bounds.
TEST(EditCircular, KeepsPanelsCircularOnTheDome) {
  const Mesh mesh = testing::sample("dome", 32);
  HandleEditSolver solver(mesh, circular());
  const std::vector<std::pair<double, double>> lifts{{0.5, 2.29}, {1.5, 10.55}};
  for (const auto& [lift, objective] : lifts) {
    const HandleEditResult result = solver.solve(testing::pull(mesh, 528, {0.0, 0.0, lift}));
    EXPECT_EQ(result.report.status, SolveStatus::kConverged);
    expect_kept(mesh, result);
    EXPECT_LE(result.report.objective.total(), objective);
    EXPECT_LE(circular_violation(result).after_max, kCircular);
    EXPECT_LT(result.moved.size(), static_cast<std::size_t>(mesh.vertex_count()) / 2);
  }
}

/// Flat panels alone do not stay circular: the promise is not kept by chance.
TEST(EditCircular, IsNotWhatFlatPanelsDoAnyway) {
  const Mesh mesh = testing::sample("dome", 16);
  const HandleEditResult result =
      solve_handle_edit(mesh, testing::pull(mesh, testing::middle_vertex(mesh), {0.0, 0.0, 0.5}));
  EXPECT_GT(testing::inscribed_defect(mesh, apply(mesh, result)), 1.0);
  EXPECT_EQ(result.report.violations.size(), 1u);
}

TEST(EditCircular, HoldsForPanelsOfSixCorners) {
  const Mesh mesh = testing::honeycomb_on_sphere(14);
  ASSERT_LT(testing::inscribed_defect(mesh, mesh.positions), 1e-10);
  ASSERT_EQ(find_broken_constraint(mesh, circular()), std::nullopt);
  const HandleEditResult result = solve_handle_edit(
      mesh, testing::pull(mesh, testing::middle_vertex(mesh), {0.1, 0.0, 0.3}), circular());
  EXPECT_FALSE(result.moved.empty());
  EXPECT_TRUE(result.report.usable());
  expect_kept(mesh, result);
}

TEST(EditCircular, EveryFrameOfADragKeepsIt) {
  const Mesh mesh = testing::sample("dome", 32);
  HandleEditSolver solver(mesh, circular());
  for (int frame = 1; frame <= 60; ++frame) {
    const HandleEditResult result =
        solver.drag(testing::pull(mesh, 528, {0.0, 0.0, 1.5 * frame / 60.0}), 1e9);
    EXPECT_TRUE(result.report.usable()) << frame;
    expect_kept(mesh, result);
  }
}

TEST(EditCircular, ComesNearerWhereHardHandlesCannotArrive) {
  const Mesh mesh = testing::sample("dome", 12);
  HandleEditOptions options = circular();
  options.hard_handles = true;
  const HandleEditResult result = solve_handle_edit(
      mesh, testing::pull(mesh, testing::middle_vertex(mesh), {0.0, 0.0, 4.0}), options);
  EXPECT_TRUE(result.report.usable());
  expect_kept(mesh, result);
}

TEST(EditCircular, OptionsMayChangeOnOneSolver) {
  const Mesh mesh = testing::sample("dome", 12);
  const EditTargets targets = testing::pull(mesh, testing::middle_vertex(mesh), {0.0, 0.0, 0.3});
  HandleEditSolver solver(mesh, {});
  const HandleEditResult flat = solver.solve(targets);
  solver.set_options(circular());
  const HandleEditResult round = solver.solve(targets);
  expect_kept(mesh, round);
  EXPECT_EQ(round.moved_positions, solve_handle_edit(mesh, targets, circular()).moved_positions);
  solver.set_options({});
  EXPECT_EQ(solver.solve(targets).moved_positions, flat.moved_positions);
}

/// A dome whose points are off by a hundredth of an edge is flat and circular again, and an edit
/// may start from it.
TEST(ProjectCircular, MakesAMeshExactlySo) {
  Mesh mesh = testing::sample("dome", 12);
  mesh.positions += 0.01 * testing::random_points(3, mesh.vertex_count());
  ProjectionOptions options;
  options.constraints = circular().constraints;
  const ProjectionResult result = project_to_planar(mesh, options);
  ASSERT_TRUE(result.report.usable()) << status_name(result.report.status);
  EXPECT_TRUE(result.failing_faces.empty());
  Mesh round = mesh;
  round.positions(Eigen::all, result.moved) = result.moved_positions;
  EXPECT_LE(testing::inscribed_defect(round, round.positions), kCircular);
  EXPECT_LE(planarity_summary(round).max_excess, testing::kPromise);
  EXPECT_LT(result.max_move, 0.2);
  ASSERT_EQ(result.report.violations.size(), 2u);
  EXPECT_GT(result.report.violations[1].before_max, 0.1);
  EXPECT_LE(result.report.violations[1].after_max, kCircular);
  EXPECT_EQ(find_broken_constraint(round, circular()), std::nullopt);
  EXPECT_TRUE(project_to_planar(round, options).moved.empty());
}

TEST(EditCircular, ABaseThatIsNotCircularIsNamed) {
  const Mesh vault = testing::sample("vault", 12);
  const auto broken = find_broken_constraint(vault, circular());
  ASSERT_TRUE(broken);
  EXPECT_NE(broken->find("not circular: panel "), std::string::npos) << *broken;
  EXPECT_EQ(find_broken_constraint(vault, {}), std::nullopt);
}

TEST(EditCircular, OptionsThatMeanNothingAreNamed) {
  HandleEditOptions options = circular();
  EXPECT_EQ(find_problem(options), std::nullopt);
  options.constraints = {{"round", 1.0}};
  EXPECT_NE(find_problem(options)->find("circular"), std::string::npos);
  options.constraints = {{"circular", 0.0}};
  EXPECT_NE(find_problem(options)->find("tolerance of circular"), std::string::npos);
  options.constraints = {{"circular", 1e-9}, {"circular", 1e-6}};
  EXPECT_NE(find_problem(options)->find("twice"), std::string::npos);
  options.constraints = {{"planar", 1e-9}};
  EXPECT_NE(find_problem(options)->find("always kept"), std::string::npos);
}

}  // namespace
}  // namespace planish
