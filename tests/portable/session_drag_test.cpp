// SPDX-License-Identifier: MIT
/// Frames of a session's drag under a limit, and how far its pull gets.
#include <gtest/gtest.h>

#include "session.hpp"
#include "support/open_session.hpp"

namespace planish {
namespace {

using testing::lift;
using testing::open_vault;

constexpr double kFrame = 10.0;  // seconds: a frame ends by its steps, not by its time

/// A vault whose folds may sharpen by so many degrees.
Session open_limited(double degrees = 10.0) {
  Session session = open_vault();
  HandleEditOptions options;
  options.attraction = 1e5;
  options.softness = 5.0;
  options.reach = 4;
  options.keep_boundary = true;
  options.bounds = {{"fold", 0.0, degrees, true}};
  EXPECT_EQ(session.set_options(options), std::nullopt);
  return session;
}

PullLimit limit_of(const Session& session) { return {.from = lift(session, 0.0).handles}; }

TEST(SessionDrag, FollowsWithinTheLimitAsEditsDo) {
  Session session = open_limited();
  Session plain = open_limited();
  for (const double height : {0.1, 0.2}) {
    const EditTargets targets = lift(session, height);
    ASSERT_EQ(session.pull(PullWay::kHold, targets, kFrame, limit_of(session)), std::nullopt);
    EXPECT_EQ(session.pulled().taken, std::nullopt);
    ASSERT_EQ(plain.edit(EditMode::kDrag, targets, kFrame), std::nullopt);
    EXPECT_EQ(session.current(), plain.current());
  }
  EXPECT_TRUE(session.pull_hold().goes_on(limit_of(session).from));
}

TEST(SessionDrag, IsHeldBackWhereFoldsDoNotLetItGoOnAndShowsWhatHeld) {
  Session session = open_limited();
  const PullLimit limit = limit_of(session);
  for (double height = 0.2; height < 3.0; height += 0.2) {
    ASSERT_EQ(session.pull(PullWay::kHold, lift(session, height), kFrame, limit), std::nullopt);
    EXPECT_LE(session.shape_report().fold_growth, 10.01);
    EXPECT_TRUE(session.pull_standing(limit, session.pull_hold().taken()).arrives);
  }
  const EditTargets far = lift(session, 5.0);
  ASSERT_EQ(session.pull(PullWay::kHold, far, kFrame, limit), std::nullopt);
  EXPECT_TRUE(session.pull_hold().held_back_from(far.handles));
  ASSERT_TRUE(session.pulled().taken);
  EXPECT_EQ(*session.pulled().taken, session.pull_hold().taken());
  EXPECT_LT(longest_way(limit.from, *session.pulled().taken), 5.0);
  EXPECT_GT(longest_way(limit.from, *session.pulled().taken), 0.0);
  session.forget_drag();
  EXPECT_FALSE(session.pull_hold().goes_on(limit.from));
}

TEST(SessionDrag, APullThatWasHeldBackAndRestsSettlesWhereItIsHeldAndStays) {
  Session session = open_limited();
  const PullLimit limit = limit_of(session);
  for (const double height : {1.0, 5.0}) {
    ASSERT_EQ(session.pull(PullWay::kHold, lift(session, height), kFrame, limit), std::nullopt);
  }
  ASSERT_TRUE(session.pulled().taken);
  const std::vector<Handle> held = *session.pulled().taken;
  for (int k = 0; k < 20; ++k) {
    ASSERT_EQ(session.pull(PullWay::kHold, lift(session, 5.0), kFrame, limit), std::nullopt);
    ASSERT_EQ(session.pulled().taken, held);
  }
  const Positions settled = session.current();
  EXPECT_NE(session.shape_report().solve.status, SolveStatus::kIterationLimit);
  ASSERT_EQ(session.pull(PullWay::kHold, lift(session, 5.0), kFrame, limit), std::nullopt);
  EXPECT_EQ(session.current(), settled);
}

TEST(SessionDrag, KeepsAFrameThatSufficesElseShowsTheOneBefore) {
  Session session = open_limited();
  const PullLimit limit = limit_of(session);
  session.keep_edit();
  ASSERT_EQ(session.pull(PullWay::kNear, lift(session, 0.1), kFrame, limit), std::nullopt);
  EXPECT_TRUE(session.pulled().suffices);
  const Positions near = session.current();
  EXPECT_NE(near, session.base().positions);
  ASSERT_EQ(session.pull(PullWay::kNear, lift(session, 5.0), kFrame, limit), std::nullopt);
  EXPECT_FALSE(session.pulled().suffices);
  EXPECT_EQ(session.current(), near);
}

TEST(SessionDrag, GoesAsFarAsHandlesGetWithinALimit) {
  constexpr double kPull = 1.5;
  Session session = open_limited(1.0);
  const PullLimit limit = limit_of(session);
  EditTargets targets = lift(session, kPull);
  ASSERT_EQ(session.pull(PullWay::kFurthest, targets, kFrame, limit), std::nullopt);
  ASSERT_TRUE(session.pulled().taken);
  targets.handles = *session.pulled().taken;
  EXPECT_GT(longest_way(limit.from, targets.handles), 0.0);
  EXPECT_LT(longest_way(limit.from, targets.handles), kPull);
  EXPECT_LE(session.shape_report().fold_growth, 1.01);
  const Positions found = session.current();
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, kFrame), std::nullopt);
  EXPECT_EQ(session.current(), found) << "the edit of the handles that are told";
  ASSERT_EQ(session.pull(PullWay::kFurthest, lift(session, 0.1), kFrame, limit), std::nullopt);
  EXPECT_EQ(session.pulled().taken, std::nullopt);
}

TEST(SessionDrag, RefusesWhatAnEditRefuses) {
  Session session = open_limited();
  EditTargets targets = lift(session, 0.5);
  targets.pins = {-1};
  const Refusal refusal = session.edit(EditMode::kDrag, targets, kFrame);
  ASSERT_TRUE(refusal);
  for (const PullWay way :
       {PullWay::kFollow, PullWay::kNear, PullWay::kHold, PullWay::kRelease, PullWay::kFurthest}) {
    EXPECT_EQ(session.pull(way, targets, kFrame, limit_of(session)), refusal);
  }
}

}  // namespace
}  // namespace planish
