// SPDX-License-Identifier: MIT
/// Panels parted where handles stop: they come nearer with every line, and it is an edit like
/// others.
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <variant>
#include <vector>

#include "planish/constraints/stated_limit.hpp"
#include "planish/cuts/cut_mesh.hpp"
#include "planish/measures/folds.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/splitting/split_where_needed.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kFold = 12.0;

/// Beside a boundary that stays, pulled by most of an edge: short by half of that without a cut.
class SplitEdits : public ::testing::Test {
 protected:
  static HandleEditOptions sharp_options() {
    HandleEditOptions options;
    options.attraction = 1e5;
    options.softness = 3.0;
    options.reach = 2;
    options.keep_boundary = true;
    options.bounds.push_back(*parse_stated_limit("fold=+12"));
    return options;
  }

  static SplitOptions at_most(int cuts) {
    SplitOptions options;
    options.most_cuts = cuts;
    return options;
  }

  [[nodiscard]] SplitEdit split(int cuts) const {
    return split_where_needed(mesh_, targets_, edit_, at_most(cuts));
  }

  const Mesh mesh_ = testing::sample("vault", 12);
  const EditTargets targets_ = testing::pull(mesh_, 26, {0.0, 0.0, 0.9});
  const HandleEditOptions edit_ = sharp_options();
};

TEST_F(SplitEdits, ComeNearerWithEveryLineAndNeverEndWorseWithMore) {
  double error = solve_handle_edit(mesh_, targets_, edit_).report.handle_error;
  const double uncut = error;
  for (int cuts = 1; cuts <= 3; ++cuts) {
    const SplitEdit found = split(cuts);
    EXPECT_LE(found.result.report.handle_error, error) << cuts;
    error = found.result.report.handle_error;
    ASSERT_FALSE(found.curve.empty());
    EXPECT_TRUE(found.curve.front().cuts.empty());
    EXPECT_EQ(found.curve.front().handle_error, uncut);
    for (std::size_t k = 1; k < found.curve.size(); ++k) {
      EXPECT_LT(found.curve[k].handle_error, found.curve[k - 1].handle_error);
      EXPECT_GT(found.curve[k].cuts.size(), found.curve[k - 1].cuts.size());
    }
    EXPECT_EQ(found.curve.back().cuts, found.cuts);
    EXPECT_LE(found.cuts.size(), static_cast<std::size_t>(cuts));
    EXPECT_EQ(found.curve.back().handle_error, error);
    EXPECT_EQ(found.curve.back().moved_vertices, found.result.report.moved_vertices);
  }
  EXPECT_LT(error, 0.5 * uncut);
}

TEST_F(SplitEdits, AreEditsOfTheCutMeshWithinTheirLimits) {
  const SplitEdit found = split(2);
  ASSERT_FALSE(found.cuts.empty());
  const auto cut = std::get<CutMesh>(cut_mesh(mesh_, found.cuts));
  EXPECT_TRUE(cut.added.empty());
  EXPECT_EQ(cut.mesh.face_offsets, found.mesh.face_offsets);
  EXPECT_EQ(cut.mesh.face_vertices, found.mesh.face_vertices);
  EXPECT_EQ(cut.mesh.positions, mesh_.positions);
  const HandleEditResult again = solve_handle_edit(cut.mesh, targets_, edit_);
  EXPECT_EQ(again.moved, found.result.moved);
  EXPECT_EQ(again.moved_positions, found.result.moved_positions);
  Mesh after = found.mesh;
  after.positions = apply(found.mesh, found.result);
  EXPECT_LE(planarity_summary(after).max_excess, edit_.tolerance);
  std::vector<int> faces(static_cast<std::size_t>(after.face_count()));
  std::iota(faces.begin(), faces.end(), 0);
  EXPECT_LE(largest_fold_growth(after, build_adjacency(after), found.mesh.positions,
                                after.positions, faces),
            kFold + 1e-6);
}

TEST_F(SplitEdits, CutNothingWhereHandlesArrive) {
  const EditTargets near = testing::pull(mesh_, 66, {0.0, 0.0, 0.1});
  const SplitEdit found = split_where_needed(mesh_, near, edit_, at_most(4));
  EXPECT_TRUE(found.reached);
  EXPECT_TRUE(found.cuts.empty());
  EXPECT_EQ(found.solves, 1);
  EXPECT_EQ(found.curve.size(), 1U);
}

TEST_F(SplitEdits, StopAfterAsManySolvesAsTheyMayOrWhereTheyAreAskedTo) {
  SplitOptions options = at_most(3);
  options.most_solves = 5;
  EXPECT_LE(split_where_needed(mesh_, targets_, edit_, options).solves, 5);
  int steps = 0;
  const Progress stop = [&](const IterationRecord&) {
    return ++steps > 200 ? Flow::kStop : Flow::kContinue;
  };
  const SplitEdit stopped = split_where_needed(mesh_, targets_, edit_, at_most(3), stop);
  EXPECT_TRUE(stopped.result.report.usable());
  EXPECT_LE(stopped.result.report.handle_error, stopped.curve.front().handle_error);
}

TEST_F(SplitEdits, NameWhatIsWrong) {
  EXPECT_FALSE(find_problem(SplitOptions{}, edit_, targets_));
  EXPECT_TRUE(find_problem(at_most(0), edit_, targets_));
  SplitOptions options;
  options.within_handle = 1.0;
  EXPECT_TRUE(find_problem(options, edit_, targets_));
  options = {};
  options.most_solves = 0;
  EXPECT_TRUE(find_problem(options, edit_, targets_));
  EXPECT_TRUE(find_problem(SplitOptions{}, edit_, EditTargets{}));
  HandleEditOptions reference = edit_;
  reference.engine = Engine::kAugmentedLagrangian;
  EXPECT_TRUE(find_problem(SplitOptions{}, reference, targets_));
}

}  // namespace
}  // namespace planish
