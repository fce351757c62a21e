// SPDX-License-Identifier: MIT
/// Few panels to make again: the handles arrive, everything else holds, and no point more can be
/// held.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

#include "planish/constraints/stated_limit.hpp"
#include "planish/edit/fewest.hpp"
#include "planish/fabrication/remake.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

struct Case {
  std::string sample;
  int size = 0;
  int vertex = 0;
  double edges = 0.0;  ///< way of the handle, mean edges
  bool with_limit = true;
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.sample << c.vertex; }

HandleEditOptions soft_options(const Case& c) {
  HandleEditOptions options;
  options.attraction = 1e5;
  options.softness = 5.0;
  options.reach = 4;
  options.keep_boundary = true;
  if (c.with_limit) options.bounds.push_back(*parse_stated_limit("fold=+15"));
  return options;
}

EditTargets targets_of(const Case& c, const Mesh& mesh) {
  return testing::pull(mesh, c.vertex, {0.0, 0.0, c.edges * mean_edge_length(mesh)});
}

class FewestEdits : public ::testing::TestWithParam<Case> {};

TEST_P(FewestEdits, ArriveWithFewerPanelsAndAreTheEditWithTheirPins) {
  const Case& c = GetParam();
  const Mesh mesh = testing::sample(c.sample, c.size);
  const HandleEditOptions options = soft_options(c);
  HandleEditSolver solver(mesh, options);
  EditTargets targets = targets_of(c, mesh);
  const FewestEdit few = find_fewest(mesh, solver, targets, {});
  ASSERT_TRUE(few.reached);
  EXPECT_TRUE(few.minimal);
  EXPECT_LE(few.panels, 0.75 * few.panels_before);
  EXPECT_LE(few.result.report.handle_error, 0.05 * c.edges * mean_edge_length(mesh));
  Mesh after = mesh;
  after.positions = apply(mesh, few.result);
  EXPECT_EQ(few.panels, find_remake(mesh, after).count(PanelChange::kOutline));
  EXPECT_LE(planarity_summary(after).max_excess, options.tolerance);
  for (const int v : few.held) EXPECT_EQ(mesh.positions.col(v), after.positions.col(v)) << v;
  if (c.with_limit) {
    const Adjacency adjacency = build_adjacency(mesh);
    std::vector<int> faces(static_cast<std::size_t>(mesh.face_count()));
    std::iota(faces.begin(), faces.end(), 0);
    EXPECT_LE(largest_fold_growth(mesh, adjacency, mesh.positions, after.positions, faces),
              15.0 + 1e-6);
  }
  targets.pins = few.held;
  HandleEditSolver other(mesh, options);
  const HandleEditResult again = other.solve(targets);
  EXPECT_EQ(again.moved, few.result.moved);
  EXPECT_EQ(again.moved_positions, few.result.moved_positions);
}

/// [FEW-1] by edits of another solver, one for each point that moves.
TEST_P(FewestEdits, HoldAllThatCanBeHeld) {
  const Case& c = GetParam();
  const Mesh mesh = testing::sample(c.sample, c.size);
  const HandleEditOptions options = soft_options(c);
  HandleEditSolver solver(mesh, options);
  const EditTargets targets = targets_of(c, mesh);
  const FewestEdit few = find_fewest(mesh, solver, targets, {});
  ASSERT_TRUE(few.minimal);
  HandleEditSolver other(mesh, options);
  for (const int v : few.result.moved) {
    if (v == c.vertex) continue;
    EditTargets held = targets;
    held.pins = few.held;
    held.pins.push_back(v);
    const HandleEditResult result = other.solve(held);
    EXPECT_TRUE(!result.report.usable() ||
                result.report.handle_error > 0.05 * c.edges * mean_edge_length(mesh))
        << v;
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, FewestEdits,
                         ::testing::Values(Case{"vault", 16, 136, 0.5}, Case{"roof", 16, 136, 0.4},
                                           Case{"hex", 14, 180, 0.2},
                                           Case{"freeform", 14, 105, 0.5},
                                           Case{"vault", 16, 120, 0.5, false}),
                         ::testing::PrintToStringParamName());

TEST(FewestEdit, OfPointsMovesNoMoreOfThemThanTheEditItself) {
  const Case c{"vault", 16, 136, 0.5};
  const Mesh mesh = testing::sample(c.sample, c.size);
  HandleEditSolver solver(mesh, soft_options(c));
  const EditTargets targets = targets_of(c, mesh);
  const std::size_t before = solver.solve(targets).moved.size();
  FewestOptions options;
  options.of = FewestOf::kPoints;
  const FewestEdit few = find_fewest(mesh, solver, targets, options);
  EXPECT_TRUE(few.minimal);
  EXPECT_LT(few.result.moved.size(), before / 2);
}

TEST(FewestEdit, HoldsNothingWhereTheHandlesDoNotArriveAnyway) {
  const Case c{"vault", 16, 136, 6.0};
  const Mesh mesh = testing::sample(c.sample, c.size);
  HandleEditSolver solver(mesh, soft_options(c));
  const EditTargets targets = targets_of(c, mesh);
  const FewestEdit few = find_fewest(mesh, solver, targets, {});
  EXPECT_FALSE(few.reached);
  EXPECT_FALSE(few.minimal);
  EXPECT_TRUE(few.held.empty());
  EXPECT_EQ(few.solves, 1);
  EXPECT_EQ(few.result.moved_positions, solver.solve(targets).moved_positions);
}

TEST(FewestEdit, StopsAfterAsManySolvesAsItMayOrWhereItIsAskedTo) {
  const Case c{"vault", 16, 136, 0.5};
  const Mesh mesh = testing::sample(c.sample, c.size);
  HandleEditSolver solver(mesh, soft_options(c));
  const EditTargets targets = targets_of(c, mesh);
  FewestOptions options;
  options.most_solves = 6;
  const FewestEdit few = find_fewest(mesh, solver, targets, options);
  EXPECT_TRUE(few.reached);
  EXPECT_FALSE(few.minimal);
  EXPECT_EQ(few.solves, 6);
  int steps = 0;
  const auto stop = [&](const IterationRecord&) {
    return ++steps < 60 ? Flow::kContinue : Flow::kStop;
  };
  const FewestEdit stopped = find_fewest(mesh, solver, targets, {}, nullptr, stop);
  EXPECT_FALSE(stopped.minimal);
  EXPECT_TRUE(stopped.result.report.usable());
  Mesh after = mesh;
  after.positions = apply(mesh, stopped.result);
  EXPECT_LE(planarity_summary(after).max_excess, soft_options(c).tolerance);
}

TEST(FewestEdit, NamesWhatIsWrong) {
  const Mesh mesh = testing::sample("vault", 6);
  const EditTargets targets = testing::pull(mesh, 14, {0.0, 0.0, 0.1});
  FewestOptions options;
  EXPECT_FALSE(find_problem(options, {}, targets).has_value());
  EXPECT_TRUE(find_problem(options, {}, {}).has_value());
  for (const double within : {0.0, -0.1, 1.0, 1.5, HUGE_VAL, std::nan("")}) {
    options.within_handle = within;
    EXPECT_TRUE(find_problem(options, {}, targets).has_value()) << within;
  }
  options = {};
  options.most_solves = 0;
  EXPECT_TRUE(find_problem(options, {}, targets).has_value());
  HandleEditOptions alm;
  alm.engine = Engine::kAugmentedLagrangian;
  EXPECT_TRUE(find_problem({}, alm, targets).has_value());
}

}  // namespace
}  // namespace planish
