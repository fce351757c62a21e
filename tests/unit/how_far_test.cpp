// SPDX-License-Identifier: MIT
/// How far along a pull an edit gets: the largest share whose target its handles meet.
#include "planish/edit/how_far.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace planish {
namespace {

struct Pulled {
  double share = 0.0;
  std::vector<double> tried = {};
  double shown = 0.0;
};

/// Handles that get to where `reach` says of a share, and what was asked of them.
Pulled pulled(const std::function<double(double)>& reach, int tries = PullLimit().tries) {
  Pulled got;
  double kept = 0.0;
  const Puller puller = {.edit = [&](double at) -> std::optional<Arrival> {
                           got.tried.push_back(at);
                           got.shown = at;
                           const double short_of = at - reach(at);
                           return Arrival{short_of, short_of - kMet * at};
                         },
                         .keep = [&] { kept = got.shown; },
                         .back = [&] { got.shown = kept; }};
  got.share = furthest(puller, tries).value();
  return got;
}

TEST(HowFar, TakesAPullThatIsMetAsItIsInOneEdit) {
  const Pulled got = pulled([](double at) { return 0.96 * at; });
  EXPECT_EQ(got.share, 1.0);
  EXPECT_EQ(got.tried, std::vector{1.0});
  EXPECT_EQ(got.shown, 1.0);
}

TEST(HowFar, EndsAboutAsFarAsHandlesGetAndShowsThat) {
  for (const double most : {0.9, 0.5, 0.25, 0.1}) {
    const auto reach = [&](double at) { return std::min(0.98 * at, most); };
    const Pulled got = pulled(reach);
    EXPECT_LE(got.share, most / (1.0 - kMet));
    EXPECT_GT(reach(got.share), 0.97 * most);
    EXPECT_EQ(got.shown, got.share);
    EXPECT_LE(got.tried.size(), 6U);
  }
}

TEST(HowFar, GoesOnFromWhereAFarTargetGotLessFarThanOneThatIsMet) {
  const Pulled got = pulled([](double at) { return at > 0.7 ? 0.3 : at; });
  EXPECT_GT(got.share, 0.65);
  EXPECT_LE(got.share, 0.7);
  EXPECT_EQ(got.shown, got.share);
}

TEST(HowFar, EndsAtTheSmallestThatWasTriedWhereNoneIsMet) {
  const Pulled got = pulled([](double) { return 0.0; });
  EXPECT_EQ(got.share, *std::min_element(got.tried.begin(), got.tried.end()));
  EXPECT_EQ(got.shown, got.share);
  EXPECT_LT(got.share, 0.05);
}

TEST(HowFar, KeepsWhatNearlyMetItsTargetWhereAllThatDoesGetsMuchLessFar) {
  const Pulled got = pulled([](double at) { return at == 1.0 ? 0.94 : 0.3 * at; });
  EXPECT_EQ(got.share, 1.0);
  EXPECT_EQ(got.shown, 1.0);
}

TEST(HowFar, EndsAboutAsFarByAFarTargetAsByANearOneWhereMoreEditsMayBeMade) {
  // Of what is met, 1 unit at most, a target that is not says little.
  const auto far = [](double length) {
    return [length](double at) { return std::min(at, at * length > 1.0 ? 0.2 / length : at); };
  };
  for (const double length : {2.0, 15.0}) {
    const double end = pulled(far(length), 8).share * length;
    EXPECT_GT(end, 0.9);
    EXPECT_LE(end, 1.0);
  }
  EXPECT_LT(pulled(far(15.0)).share * 15.0, 0.9);
}

TEST(HowFar, EndsAtOnceWhereAnEditIsRefused) {
  int edits = 0;
  const auto refuse = [&](double) -> std::optional<Arrival> {
    ++edits;
    return std::nullopt;
  };
  EXPECT_EQ(furthest({.edit = refuse, .keep = [] {}, .back = [] {}}, 4), std::nullopt);
  EXPECT_EQ(edits, 1);
}

TEST(HowFar, AnEditStopsShortBySharesOfItsPull) {
  EditStanding edit{.moved_vertices = 9, .handle_error = 0.5, .is_bound = true};
  const Arrival got = arrival_of({}, 2.0, 4.0, edit);
  EXPECT_EQ(got.short_of, 0.125);
  EXPECT_NEAR(got.over, 0.1, 1e-12);
  edit.is_bound = false;
  EXPECT_LE(arrival_of({}, 2.0, 4.0, edit).over, 0.0);
  edit.status = SolveStatus::kInfeasibleHandles;
  edit.handle_error = 0.01;
  EXPECT_GT(arrival_of({}, 2.0, 4.0, edit).over, 0.0);
}

}  // namespace
}  // namespace planish
