// SPDX-License-Identifier: MIT
/// Handles that go to their targets in steps. [PTH-1]
#include <gtest/gtest.h>

#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/shapes/shapes.hpp"

namespace planish {
namespace {

constexpr double kNoBudget = 1e9;  // seconds

/// What the page starts with: an edit with two minima, one at once, one along the way.
class Continuation : public ::testing::Test {
 protected:
  HandleEditResult solve(int steps) {
    targets_.continuation = steps;
    return HandleEditSolver(mesh_, options_).solve(targets_);
  }

  [[nodiscard]] double gap(const HandleEditResult& a, const HandleEditResult& b) const {
    return (apply(mesh_, a) - apply(mesh_, b)).colwise().norm().maxCoeff() / pull_.norm();
  }

  static constexpr int kVertex = 81;
  Mesh mesh_ = *make_sample("vault", 20);
  Eigen::Vector3d pull_{-0.755, 0.664, -0.252};
  HandleEditOptions options_ = [] {
    HandleEditOptions options;
    options.attraction = 1e4;
    options.reach = 6;
    options.keep_boundary = true;
    options.softness = 5.0;
    return options;
  }();
  EditTargets targets_{.handles = {{kVertex, mesh_.positions.col(kVertex) + pull_}}};
};

TEST_F(Continuation, EndsWhereADragOfAsManyFramesDoes) {
  constexpr int kSteps = 16;
  HandleEditSolver solver(mesh_, options_);
  HandleEditResult frame;
  for (int k = 1; k <= kSteps; ++k) {
    const double share = static_cast<double>(k) / kSteps;
    frame = solver.drag({.handles = {{kVertex, mesh_.positions.col(kVertex) + share * pull_}}},
                        kNoBudget);
  }
  EXPECT_GT(gap(frame, solve(0)), 0.1) << "at once is another minimum: else this tests nothing";
  EXPECT_LT(gap(frame, solve(kSteps)), 0.01);
}

TEST_F(Continuation, IsCertifiedFlatAndSound) {
  const HandleEditResult result = solve(16);
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
  ASSERT_TRUE(result.report.optimality.has_value());
  EXPECT_TRUE(result.report.optimality->met());
  Mesh after = mesh_;
  after.positions = apply(mesh_, result);
  EXPECT_LE(planarity_summary(after).max_excess, options_.tolerance);
}

TEST_F(Continuation, DependsOnMeshOptionsAndTargetsAlone) {
  const HandleEditResult fresh = solve(16);
  HandleEditSolver used(mesh_, options_);
  EditTargets other{.handles = {{210, mesh_.positions.col(210) + Eigen::Vector3d(0, 0, 0.5)}}};
  static_cast<void>(used.solve(other));
  static_cast<void>(used.drag(other, kNoBudget));
  const HandleEditResult again = used.solve(targets_);
  EXPECT_EQ(again.moved, fresh.moved);
  EXPECT_EQ(again.moved_positions, fresh.moved_positions);
}

TEST_F(Continuation, OutOfRangeIsRefusedByName) {
  for (const int steps : {-1, kMostContinuation + 1}) {
    targets_.continuation = steps;
    EXPECT_EQ(find_problem(targets_, mesh_),
              "continuation must be 0 (at once) or from 1 to 1000 steps");
  }
}

}  // namespace
}  // namespace planish
