// SPDX-License-Identifier: MIT
/// How far a drag goes on under its limit.
#include "planish/edit/pull_hold.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace planish {
namespace {

using Handles = std::vector<Handle>;

const Handles kFrom = {{7, {0.0, 0.0, 1.0}}};

Handles raised(double height) { return {{7, {0.0, 0.0, 1.0 + height}}}; }
double height_of(const Handles& handles) { return handles[0].target.z() - 1.0; }

/// Edits that fold by ten degrees for every unit of height, and are within a limit at the start.
constexpr double kFold = 10.0;

/// Frames that arrive up to `limit` degrees; what was asked for and how, and what is shown.
struct Drag {
  double limit = 15.0;
  double unsettled = 0.0;  ///< by which a frame that follows the last folds more
  bool refuses = false;
  std::vector<Handles> seen = {};
  std::vector<bool> kinds = {};
  Handles shown = {}, kept = {};

  PullFrames frames() {
    PullFrames frames;
    frames.edit = [this](const Handles& handles, bool settled) -> std::optional<bool> {
      seen.push_back(handles);
      kinds.push_back(settled);
      if (refuses) return std::nullopt;
      shown = handles;
      return kFold * height_of(handles) + (settled ? 0.0 : unsettled) <= limit;
    };
    frames.keep = [this] { kept = shown; };
    frames.back = [this] { shown = kept; };
    return frames;
  }

  std::optional<bool> take(PullHold& hold, const Handles& to, bool is_late = false) {
    return hold.take(kFrom, to, frames(), [is_late] { return is_late; });
  }
};

TEST(PullHold, LetsAPullWithinTheLimitThroughAsItIsInOneTry) {
  PullHold hold;
  Drag drag;
  EXPECT_EQ(drag.take(hold, raised(1.5)), true);
  EXPECT_EQ(drag.seen, std::vector<Handles>{raised(1.5)});
  EXPECT_EQ(hold.taken(), raised(1.5));
}

TEST(PullHold, ShowsHandlesThatHoldAfterEveryFrameAndComesWithinAFiftiethOfTheLimit) {
  PullHold hold;
  Drag drag;
  for (double height = 0.1; height < 4.0; height += 0.1) {
    const std::size_t before = drag.seen.size();
    const bool arrived = drag.take(hold, raised(height)).value();
    EXPECT_EQ(arrived, hold.taken() == raised(height));
    EXPECT_LE(kFold * height_of(hold.taken()), 15.0);
    EXPECT_EQ(drag.shown, hold.taken());
    EXPECT_LE(drag.seen.size() - before, 7U);
  }
  EXPECT_GT(height_of(hold.taken()), 1.5 - 0.02 * 4.0);
}

TEST(PullHold, KnowsWhetherTheLastPullWasHeldBackAndFromWhere) {
  PullHold hold;
  Drag drag;
  EXPECT_FALSE(hold.goes_on(kFrom));
  (void)drag.take(hold, raised(1.5));
  EXPECT_TRUE(hold.goes_on(kFrom));
  EXPECT_FALSE(hold.goes_on(raised(1.0)));
  EXPECT_FALSE(hold.held_back_from(raised(1.5)));
  (void)drag.take(hold, raised(4.0));
  EXPECT_TRUE(hold.held_back_from(raised(4.0)));
  EXPECT_FALSE(hold.held_back_from(raised(3.0)));
  (void)drag.take(hold, raised(1.0));
  EXPECT_FALSE(hold.held_back_from(raised(4.0)));
}

TEST(PullHold, LetsTheOtherDirectionGoAndTheWayBack) {
  PullHold hold;
  Drag drag;
  EXPECT_EQ(drag.take(hold, raised(4.0)), false);
  EXPECT_EQ(drag.take(hold, raised(-3.0)), true);
  EXPECT_EQ(drag.take(hold, raised(1.0)), true);
}

TEST(PullHold, StaysAtWhatHeldWhereNothingHoldsFurtherOnAnyMore) {
  PullHold hold;
  Drag drag;
  (void)drag.take(hold, raised(1.4));
  drag.limit = -100.0;
  EXPECT_EQ(drag.take(hold, raised(1.9)), false);
  EXPECT_EQ(hold.taken(), raised(1.4));
  EXPECT_EQ(drag.shown, raised(1.4));
}

TEST(PullHold, StaysAtWhatIsShownWhereTheLongestThatHeldDoesNotComeBack) {
  PullHold hold;
  Drag drag;
  (void)drag.take(hold, raised(9.0));
  drag.limit = 8.0;
  EXPECT_EQ(drag.take(hold, raised(0.5)), true);
  EXPECT_EQ(drag.take(hold, raised(9.0)), false);
  EXPECT_EQ(hold.taken(), raised(0.5));
  EXPECT_EQ(drag.shown, raised(0.5));
}

TEST(PullHold, AsksForASettledEditWhereAFrameDidNotHoldAndForNoneWhileItStays) {
  PullHold hold;
  Drag drag{.unsettled = 20.0};
  EXPECT_EQ(drag.take(hold, raised(1.2)), true);
  EXPECT_EQ(drag.kinds, (std::vector{false, true}));
  (void)drag.take(hold, raised(9.0));
  const std::size_t tried = drag.kinds.size();
  for (int k = 0; k < 6; ++k) (void)drag.take(hold, raised(9.0 + k));
  EXPECT_LT(drag.kinds.size() - tried, 12U);
  const std::size_t still = drag.kinds.size();
  (void)drag.take(hold, raised(15.0));
  EXPECT_EQ(drag.kinds.size(), still);
}

TEST(PullHold, MakesOneFrameEachOnceASearchTookTooLongAndSaysWhatHeldLast) {
  PullHold hold;
  Drag drag;
  (void)drag.take(hold, raised(1.0), true);
  (void)drag.take(hold, raised(9.0), true);
  drag.seen.clear();
  EXPECT_EQ(drag.take(hold, raised(8.0)), false);
  EXPECT_EQ(hold.taken(), raised(1.0));
  EXPECT_EQ(drag.take(hold, raised(1.2)), true);
  EXPECT_EQ(drag.seen, (std::vector<Handles>{raised(8.0), raised(1.2)}));
}

TEST(PullHold, TriesWhatHeldOneWayWhenThePullTurnsALittleAndNoMoreInThatFrame) {
  PullHold hold;
  Drag drag;
  (void)drag.take(hold, raised(9.0));
  const double held = height_of(hold.taken());
  drag.kinds.clear();
  for (const double sideways : {4.0, 0.0, -4.0, 4.0}) {
    EXPECT_EQ(drag.take(hold, {{7, {sideways, 0.0, 10.0}}}), false);
    EXPECT_NEAR((hold.taken()[0].target - kFrom[0].target).norm(), held, 1e-9);
  }
  EXPECT_EQ(drag.kinds, (std::vector{false, false, false, false}));
}

TEST(PullHold, EndsAtOnceWhereAnEditIsRefused) {
  PullHold hold;
  Drag drag;
  (void)drag.take(hold, raised(1.0));
  drag.refuses = true;
  EXPECT_EQ(drag.take(hold, raised(9.0)), std::nullopt);
  EXPECT_EQ(drag.seen.size(), 2U);
  EXPECT_EQ(hold.taken(), raised(1.0));
}

TEST(PullHold, TakesAllHandlesBackByTheSameShareAndKeepsTheBitsOfThoseThatStay) {
  const Handles from = {{3, {0.1, 0.2, 0.3}}, {5, {1.0, 1.0, 1.0}}};
  const Handles to = {{3, {0.1, 0.2, 2.3}}, {5, {5.0, 1.0, 1.0}}};
  EXPECT_EQ(between(from, to, 1.0), to);
  const Handles half = between(from, to, 0.5);
  EXPECT_EQ(half[0].target, Eigen::Vector3d(0.1, 0.2, 0.3 + 0.5 * (2.3 - 0.3)));
  EXPECT_EQ(half[1].target, Eigen::Vector3d(3.0, 1.0, 1.0));
  EXPECT_EQ(longest_way(from, to), 4.0);
}

/// An edit of a handle that was asked to go 2 units.
constexpr double kWay = 2.0;
const EditStanding kEdit = {.moved_vertices = 9};

EditStanding bound(double handle_error) {
  EditStanding edit = kEdit;
  edit.handle_error = handle_error;
  edit.is_bound = true;
  return edit;
}

EditStanding free(double handle_error, SolveStatus status = SolveStatus::kConverged) {
  EditStanding edit = kEdit;
  edit.handle_error = handle_error;
  edit.status = status;
  return edit;
}

TEST(PullLimits, AnEditArrivesWithinATwentiethOfTheWayOrAsFarAsNothingButPanelsLetsIt) {
  EXPECT_TRUE(arrives({}, kWay, bound(0.09)));
  EXPECT_FALSE(arrives({}, kWay, bound(0.11)));
  EXPECT_TRUE(arrives({}, kWay, free(0.9)));
}

TEST(PullLimits, AnEditMayStayAsShortAsTheDragBegan) {
  EXPECT_TRUE(arrives({.short_share = 0.3, .from = {}}, kWay, bound(0.59)));
  EXPECT_FALSE(arrives({.short_share = 0.3, .from = {}}, kWay, bound(0.61)));
}

TEST(PullLimits, AnEditLagsWhereNothingButTimeKeepsItsHandlesFromArriving) {
  constexpr SolveStatus kLate = SolveStatus::kIterationLimit;
  EditStanding held = free(0.5, kLate);
  held.is_bound = true;
  EXPECT_TRUE(lags({}, kWay, free(0.5, kLate)));
  EXPECT_FALSE(lags({}, kWay, held));
  EXPECT_FALSE(lags({}, kWay, free(0.5)));
  EXPECT_FALSE(lags({}, kWay, free(0.05, kLate)));
}

TEST(PullLimits, AnEditThatFoundNoWayToMoveDoesNotArrive) {
  EditStanding stuck = free(0.0, SolveStatus::kIterationLimit);
  EXPECT_TRUE(arrives({}, kWay, stuck));
  stuck.moved_vertices = 0;
  EXPECT_FALSE(arrives({}, kWay, stuck));
  EXPECT_FALSE(arrives({}, kWay, free(0.0, SolveStatus::kInfeasibleHandles)));
}

TEST(PullLimits, ABoundIsOneThatHoldsSomething) {
  SolveReport report;
  EXPECT_FALSE(is_bound(report));
  report.bounds = {{"fold", {}}};
  EXPECT_FALSE(is_bound(report));
  report.bounds.push_back({"angle", {3}});
  EXPECT_TRUE(is_bound(report));
}

TEST(PullLimits, AnEditSufficesWhereHandlesArriveFoldsStayFairAndNothingBinds) {
  EditStanding edit = free(0.04 * kWay);
  edit.fold_growth = 10.0;
  EXPECT_TRUE(suffices(edit, kWay, kMet));
  EXPECT_FALSE(suffices(free(0.06 * kWay), kWay, kMet));
  EXPECT_FALSE(suffices(bound(0.0), kWay, kMet));
  edit.fold_growth = 10.1;
  EXPECT_FALSE(suffices(edit, kWay, kMet));
  EXPECT_FALSE(suffices(free(0.0, SolveStatus::kInfeasibleHandles), kWay, kMet));
  // A frame whose time is over may be near enough; one that found no way to move is not.
  EditStanding late = free(0.04 * kWay, SolveStatus::kIterationLimit);
  EXPECT_TRUE(suffices(late, kWay, kMet));
  late.moved_vertices = 0;
  EXPECT_FALSE(suffices(late, kWay, kMet));
}

}  // namespace
}  // namespace planish
