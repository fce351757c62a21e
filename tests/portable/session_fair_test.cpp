// SPDX-License-Identifier: MIT
/// The limits that a session's edit gets where they cost its handles nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include "session.hpp"
#include "support/open_session.hpp"

namespace planish {
namespace {

using testing::lift;
using testing::open_vault;

HandleEditOptions soft() {
  HandleEditOptions options;
  options.softness = 5.0;
  options.reach = 4;
  options.keep_boundary = true;
  return options;
}

FairSearch search_for(double height) { return {.way = height}; }

TEST(SessionFair, FindsTheLimitOnFoldsThatCostsNothingAndKeepsIt) {
  Session session = open_vault();
  ASSERT_EQ(session.set_options(soft()), std::nullopt);
  const EditTargets targets = lift(session, 0.7);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 1.0), std::nullopt);
  const ShapeReport free = session.shape_report();
  ASSERT_GT(free.fold_growth, 15.0) << "else this tests nothing";
  ASSERT_EQ(session.edit_fairly(EditMode::kSolve, targets, 1.0, search_for(0.7)), std::nullopt);
  ASSERT_FALSE(session.fair_found().empty());
  const StatedLimit& fold = session.fair_found().front();
  EXPECT_EQ(fold.name, "fold");
  EXPECT_TRUE(fold.relative);
  EXPECT_LE(session.shape_report().fold_growth, fold.most + 0.01);
  EXPECT_LE(session.shape_report().handle_error, free.handle_error + 0.05 * 0.7);
  const Positions found = session.current();
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 1.0), std::nullopt);
  EXPECT_EQ(session.current(), found) << "the limits are those of all edits from there on";
  HandleEditOptions stated = soft();
  stated.bounds = session.fair_found();
  Session other = open_vault();
  ASSERT_EQ(other.set_options(stated), std::nullopt);
  ASSERT_EQ(other.edit(EditMode::kSolve, targets, 1.0), std::nullopt);
  EXPECT_EQ(other.current(), found) << "bit by bit, from the recipe alone";
}

TEST(SessionFair, LeavesAGentleEditAsItIs) {
  Session session = open_vault();
  ASSERT_EQ(session.set_options(soft()), std::nullopt);
  const EditTargets targets = lift(session, 0.1);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 1.0), std::nullopt);
  const Positions free = session.current();
  ASSERT_EQ(session.edit_fairly(EditMode::kSolve, targets, 1.0, search_for(0.1)), std::nullopt);
  EXPECT_TRUE(session.fair_found().empty());
  EXPECT_EQ(session.current(), free);
}

TEST(SessionFair, RefusesWhatAnEditRefuses) {
  Session session = open_vault();
  EditTargets targets = lift(session, 0.5);
  targets.handles[0].vertex = -1;
  EXPECT_EQ(session.edit_fairly(EditMode::kSolve, targets, 1.0, search_for(0.5)),
            session.edit(EditMode::kSolve, targets, 1.0));
  EXPECT_TRUE(session.fair_found().empty());
  EXPECT_EQ(session.current(), session.base().positions);
}

}  // namespace
}  // namespace planish
