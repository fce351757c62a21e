// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "session.hpp"
#include "support/mesh_builders.hpp"
#include "support/open_session.hpp"

namespace planish {
namespace {

using testing::kWideAndSmall;
using testing::lift;
using testing::open_vault;

TEST(SessionReplay, ARestoredDesignIsTheSameToTheLastBit) {
  Session session = open_vault();
  const EditTargets targets = lift(session, 0.5);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 1.0), std::nullopt);
  const std::vector<int> moved = session.moved();
  const Positions positions = session.moved_positions();
  const auto file = session.write("obj");
  ASSERT_EQ(session.restore({}, {}, Positions(3, 0)), std::nullopt);
  ASSERT_EQ(session.restore(targets, moved, positions), std::nullopt);
  EXPECT_EQ(session.write("obj"), file);
}

/// A vault's middle point lifted, with two families of variations, one after the other.
Design varied_vault(const Session& session) {
  Design design;
  design.targets = lift(session, 0.8);
  design.options.softness = 5.0;
  design.options.reach = 6;
  design.variations = {{{.dimension = 3}, {0.4, -0.2}, true},
                       {{.dimension = 2, .eigenbasis = true}, {0.3, 0.1}, true}};
  return design;
}

TEST(SessionReplay, ReplaysADesignToTheBitsOfItsSteps) {
  Session by_steps = open_vault(), replayed = open_vault();
  Design design = varied_vault(by_steps);
  ASSERT_EQ(by_steps.set_options(design.options), std::nullopt);
  ASSERT_EQ(by_steps.edit(EditMode::kSolve, design.targets, 1.0), std::nullopt);
  Positions centre;
  for (const DesignVariation& variation : design.variations) {
    centre = by_steps.moved_positions();
    ASSERT_EQ(by_steps.explore(variation.options), std::nullopt);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(by_steps.variations_report().dimension);
    for (std::size_t k = 0; k < variation.coefficients.size(); ++k) {
      values[static_cast<Eigen::Index>(k)] = variation.coefficients[k];
    }
    ASSERT_EQ(by_steps.vary(values), std::nullopt);
    ASSERT_EQ(by_steps.make_exact(), std::nullopt);
  }
  design.result = mark_of(by_steps.base(), by_steps.current());
  ASSERT_EQ(replayed.replay(design), std::nullopt);
  EXPECT_TRUE(testing::same_bits(replayed.current(), by_steps.current()));
  EXPECT_EQ(replayed.moved(), by_steps.moved());
  EXPECT_EQ(replayed.replayed().deviation, 0.0);
  EXPECT_EQ(replayed.replayed().directions, (std::vector<int>{3, 2}));
  EXPECT_TRUE(testing::same_bits(replayed.replayed().centre.positions, centre));
  const ShapeReport &a = replayed.shape_report(), &b = by_steps.shape_report();
  EXPECT_EQ(a.solve.status, b.solve.status);
  EXPECT_EQ(a.handle_error, b.handle_error);
  EXPECT_EQ(a.solve.cost.steps, b.solve.cost.steps);
  // The sliders go on from where the design has them.
  const Eigen::Vector2d further(0.5, -0.4);
  ASSERT_EQ(by_steps.vary(further), std::nullopt);
  ASSERT_EQ(replayed.vary(further), std::nullopt);
  EXPECT_TRUE(testing::same_bits(replayed.current(), by_steps.current()));
}

TEST(SessionReplay, ARefusedReplayLeavesTheSessionAsItWas) {
  Session session = open_vault();
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.5), 1.0), std::nullopt);
  const Positions before = session.current();
  Design design = varied_vault(session);
  Refusal refusal = session.replay(design, mesh_hash(session.base()) ^ 1U);
  ASSERT_NE(refusal, std::nullopt);
  EXPECT_NE(refusal->find("source.hash"), std::string::npos) << *refusal;
  EXPECT_NE(session.replay(design, 0U), std::nullopt) << "0 is a hash like any other";
  design.targets.handles[0].vertex = 9999;
  refusal = session.replay(design);
  ASSERT_NE(refusal, std::nullopt);
  EXPECT_EQ(refusal->front(), 'H') << *refusal;
  EXPECT_EQ(refusal->back(), '.') << *refusal;
  EXPECT_TRUE(testing::same_bits(session.current(), before));
}

TEST(SessionReplay, ADesignWithoutAnEditIsItsBase) {
  Session session;
  ASSERT_EQ(session.open_file(kWideAndSmall, "obj"), std::nullopt);
  EXPECT_EQ(session.replay({}, mesh_hash(session.base())), std::nullopt) << "flat or not";
  EXPECT_TRUE(session.moved().empty());
}

TEST(SessionReplay, RefusesADesignOfAnotherMesh) {
  Session session = open_vault();
  EXPECT_NE(session.restore({}, {9999}, Positions::Zero(3, 1)), std::nullopt);
  EXPECT_NE(session.restore({}, {3, 2}, Positions::Zero(3, 2)), std::nullopt);
  EXPECT_NE(session.restore({}, {3}, Positions::Zero(3, 2)), std::nullopt);
  EXPECT_TRUE(session.moved().empty());
}

TEST(SessionReplay, VariationsOutliveARestoreThatKeepsThem) {
  Session session = open_vault();
  const EditTargets targets = lift(session, 1.0);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 0.0), std::nullopt);
  ASSERT_EQ(session.explore({.dimension = 2}), std::nullopt);
  const std::vector<int> moved = session.moved();
  const Positions positions = session.moved_positions();
  const Eigen::Vector2d x(0.5, 0.5);
  ASSERT_EQ(session.vary(x), std::nullopt);
  const Positions varied = session.current();
  ASSERT_EQ(session.restore(targets, moved, positions, true), std::nullopt);
  ASSERT_EQ(session.vary(x), std::nullopt);
  EXPECT_TRUE(testing::same_bits(session.current(), varied));
  ASSERT_EQ(session.restore(targets, moved, positions), std::nullopt);
  EXPECT_NE(session.vary(x), std::nullopt);
}

TEST(SessionReplay, AProjectedVariationIsTheExactOneAndChangesNothing) {
  Session session = open_vault();
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.5), 1.0), std::nullopt);
  ASSERT_NE(session.project_variation(Eigen::VectorXd::Zero(2)), std::nullopt);
  ASSERT_EQ(session.explore({.dimension = 2}), std::nullopt);
  const Positions before = session.current();
  const Eigen::Vector2d coefficients(0.6, -0.4);
  ASSERT_EQ(session.project_variation(coefficients), std::nullopt);
  EXPECT_EQ(session.current(), before);
  const std::vector<int> moved = session.projected().moved;
  const Positions positions = session.projected().positions;
  ASSERT_EQ(session.vary(coefficients), std::nullopt);
  ASSERT_EQ(session.make_exact(), std::nullopt);
  EXPECT_EQ(session.moved(), moved);
  EXPECT_EQ(session.moved_positions(), positions);
  EXPECT_NE(session.project_variation(Eigen::VectorXd::Zero(3)), std::nullopt);
}

/// How far the design shown is from the target that it misses most.
double furthest(const Session& session, const EditTargets& targets) {
  double largest = 0.0;
  for (const auto& [vertex, target] : targets.handles) {
    largest = std::max(largest, (session.current().col(vertex) - target).norm());
  }
  return largest;
}

TEST(SessionReplay, TheReportSpeaksOfTheDesignShown) {
  Session session = open_vault();
  const EditTargets targets = lift(session, 0.5);
  const auto expect_told = [&] {
    const double told = session.shape_report().handle_error;
    EXPECT_EQ(told, furthest(session, targets));
    return told;
  };
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 1.0), std::nullopt);
  const double edited = expect_told();
  const std::vector<int> moved = session.moved();
  const Positions shape = session.moved_positions();
  ASSERT_EQ(session.explore({.dimension = 1}), std::nullopt);
  ASSERT_EQ(session.vary(Eigen::VectorXd::Constant(1, 0.8)), std::nullopt);
  EXPECT_GT(expect_told(), edited);
  ASSERT_EQ(session.make_exact(), std::nullopt);
  EXPECT_GT(expect_told(), edited);
  ASSERT_EQ(session.restore(targets, moved, shape), std::nullopt);
  EXPECT_EQ(expect_told(), edited);
}

TEST(SessionReplay, AVariationKeepsThePartsOfTheEditThatNoVectorMoves) {
  Session session = open_vault();
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.5), 1.0), std::nullopt);
  ASSERT_EQ(session.explore({.dimension = 1, .reach = 0}), std::nullopt);
  const Positions edited = session.current();
  ASSERT_EQ(session.vary(Eigen::VectorXd::Zero(1)), std::nullopt);
  EXPECT_EQ(session.current(), edited);
}

}  // namespace
}  // namespace planish
