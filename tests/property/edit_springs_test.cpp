// SPDX-License-Identifier: MIT
/// What springs do: their points go less or more willingly, and nothing else changes. [SUP-5]
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"
#include "support/supported_edit.hpp"

namespace planish {
namespace {

using testing::support;

/// Lifts of the middle vertex with a spring at the points around it.
class EditSprings : public testing::SupportedEdit {
 protected:
  [[nodiscard]] EditTargets sprung(const std::string& stiffness, double lift = 0.5) const {
    EditTargets targets = lifted(lift);
    std::string text = "spring=" + stiffness + ":";
    for (const int v : around()) {
      if (text.back() != ':') text += ',';
      text += std::to_string(v);
    }
    targets.supports = {support(text)};
    return targets;
  }
  /// The mean way of the points around the handle, mean edges.
  [[nodiscard]] double mean_way(const HandleEditResult& result) const {
    double sum = 0.0;
    for (const int v : around()) sum += way_of(result, v);
    return sum / static_cast<double>(around().size()) / mean_edge_length(mesh);
  }
  [[nodiscard]] HandleEditResult solve_softly(const EditTargets& targets) const {
    HandleEditOptions options;
    options.softness = 4.0;
    HandleEditResult result = solve_handle_edit(mesh, targets, options);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    return result;
  }
};

TEST_P(EditSprings, TheStifferTheLessItsPointsMove) {
  double before = 1e9;
  for (const char* stiffness : {"0.2", "1", "4", "20", "200"}) {
    const HandleEditResult result = solve_softly(sprung(stiffness));
    EXPECT_EQ(result.report.status, SolveStatus::kConverged) << stiffness;
    const double way = mean_way(result);
    EXPECT_LE(way, before + 1e-9) << stiffness;
    before = way;
  }
  const double free = mean_way(solve_softly(lifted(0.5)));
  EXPECT_LT(before, 0.5 * free) << "200 times as stiff";
}

TEST_P(EditSprings, AsStiffAsTheOthersIsNoSpring) {
  EXPECT_EQ(apply(mesh, solve(sprung("1"))), apply(mesh, solve(lifted(0.5))));
}

TEST_P(EditSprings, FramesOfADragAreValidAndEndWhereTheyBegan) {
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  HandleEditSolver solver(mesh, {});
  for (int frame = 1; frame <= 12; ++frame) {
    const double lift = 0.8 * (1.0 - std::abs(frame - 6) / 6.0);
    const EditTargets targets = sprung("5", lift);
    const HandleEditResult result = solver.drag(targets, kBudget);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result)) << "frame " << frame;
  }
  EXPECT_EQ(apply(mesh, solver.solve(lifted(0.5))), apply(mesh, solve(lifted(0.5))))
      << "a spring that is gone leaves nothing behind";
}

/// Pins, handles and what stands on something are what they were.
TEST_P(EditSprings, WhatIsFixedStaysFixedUnderASoftSpring) {
  EditTargets targets = sprung("0.05");
  targets.pins = {around().front()};
  targets.supports.push_back(support("level=z:" + std::to_string(around().back())));
  const Positions after = apply(mesh, solve(targets));
  EXPECT_EQ(after.col(around().front()), mesh.positions.col(around().front()));
  EXPECT_EQ(after(2, around().back()), mesh.positions(2, around().back()));
}

TEST(EditSpringRules, AStiffnessHasARange) {
  for (const char* text : {"spring=0:1", "spring=-2:1", "spring=1001:1", "spring=nan:1"}) {
    const auto spring = parse_point_support(text);
    EXPECT_TRUE(!spring || find_problem(std::vector{*spring})) << text;
  }
  EXPECT_EQ(find_problem(std::vector{support("spring=0.001:1")}),
            "supports: spring=0.001: its stiffness must be from 0.01 to 1000");
  EXPECT_EQ(point_support_text(support("spring=0.25:7,8")), "spring=0.25:7,8");
  EXPECT_FALSE(parse_point_support("spring:7"));
}

/// Variations hold what stands on something, but not what only moves less willingly.
TEST(EditSpringRules, VariationsMoveItsPoints) {
  const Mesh mesh = testing::quad_grid(6, 6);
  EditTargets targets = testing::pull(mesh, 21, {0.0, 0.0, 0.5});
  targets.supports = {support("spring=3:14")};
  EXPECT_TRUE(kept_by_variations(mesh, targets, {}).held.empty());
}

INSTANTIATE_TEST_SUITE_P(Samples, EditSprings, ::testing::Values("roof", "dome", "hex", "trihex"),
                         &testing::sample_name);

}  // namespace
}  // namespace planish
