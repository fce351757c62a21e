// SPDX-License-Identifier: MIT
/// Which limits an edit gets of itself: those that cost its handles nothing.
#include "planish/edit/fair_limits.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "planish/edit/fewest.hpp"

namespace planish {
namespace {

using Texts = std::vector<std::string>;

constexpr double kWay = 2.0;
const std::string kCorners(kBuildableCorners);

EditStanding standing(double growth, double short_of, int slivers = 0) {
  return {.moved_vertices = 9,
          .handle_error = short_of * kWay,
          .fold_growth = growth,
          .slivers = slivers};
}

EditStanding given_up(EditStanding standing) {
  standing.status = SolveStatus::kInfeasibleHandles;
  return standing;
}

std::string text_of(const std::vector<StatedLimit>& limits) {
  std::string text;
  for (const StatedLimit& limit : limits) text += " " + stated_limit_text(limit);
  return text.empty() ? text : text.substr(1);
}

struct Found {
  std::string limits;
  Texts tried;  ///< the limits of each edit that was made
};

/// Edits that end as `answers` says, by their limits; any other is refused.
Found find(const EditStanding& free, std::map<std::string, EditStanding> answers,
           FairSearch search = {.way = kWay}) {
  answers[""] = free;
  Found found;
  const auto edit = [&](const std::vector<StatedLimit>& limits) -> std::optional<EditStanding> {
    found.tried.push_back(text_of(limits));
    const auto answer = answers.find(found.tried.back());
    return answer == answers.end() ? std::nullopt : std::optional(answer->second);
  };
  found.limits = text_of(find_fair_limits(free, search, edit));
  return found;
}

TEST(FairLimits, AreNoneWhereNoFoldSharpensByMoreThanTenDegreesAndNothingIsTried) {
  const Found found = find(standing(10.0, 0.01), {});
  EXPECT_EQ(found.limits, "");
  EXPECT_EQ(found.tried, Texts());
}

TEST(FairLimits, OnFoldsAreTheFirstWithWhichHandlesLoseNoMoreThanATwentiethOfTheirWay) {
  const Found second = find(standing(60.0, 0.01), {{"fold=+10", standing(10.0, 0.2)},
                                                   {"fold=+20", standing(20.0, 0.05)}});
  EXPECT_EQ(second.limits, "fold=+20");
  EXPECT_EQ(second.tried, (Texts{"fold=+10", "fold=+20"}));
  const Found first = find(standing(60.0, 0.01), {{"fold=+10", standing(10.0, 0.059)}});
  EXPECT_EQ(first.limits, "fold=+10");
  EXPECT_EQ(first.tried, Texts{"fold=+10"});
}

TEST(FairLimits, AreNoneWhereEachCostsTheHandlesMoreAndTheEditIsMadeAgainWithoutThem) {
  const std::map<std::string, EditStanding> far = {{"fold=+10", standing(10.0, 0.3)},
                                                   {"fold=+20", standing(20.0, 0.3)}};
  const Found both = find(standing(60.0, 0.01), far);
  EXPECT_EQ(both.limits, "");
  EXPECT_EQ(both.tried, (Texts{"fold=+10", "fold=+20", ""}));
  EXPECT_EQ(find(standing(14.0, 0.01), far).tried, (Texts{"fold=+10", ""}));
}

TEST(FairLimits, TakeNoEditThatGaveUpOrMovedNothingOrIsRefusedThoughItIsAsNear) {
  const EditStanding free = standing(14.0, 0.01);
  const EditStanding near = standing(10.0, 0.01);
  EXPECT_EQ(find(free, {{"fold=+10", near}}).limits, "fold=+10");
  EXPECT_EQ(find(free, {{"fold=+10", given_up(near)}}).limits, "");
  EditStanding still = near;
  still.moved_vertices = 0;
  EXPECT_EQ(find(free, {{"fold=+10", still}}).limits, "");
  const Found refused = find(free, {});
  EXPECT_EQ(refused.limits, "");
  EXPECT_EQ(refused.tried, (Texts{"fold=+10", ""}));
}

TEST(FairLimits, AreLookedForOnlyWhereTheyAreAskedFor) {
  const EditStanding free = standing(60.0, 0.01, 3);
  const FairSearch corners{.way = kWay, .folds = false};
  const FairSearch folds{.way = kWay, .corners = false};
  EXPECT_EQ(find(free, {}, corners).tried, (Texts{kCorners, ""}));
  EXPECT_EQ(find(free, {}, folds).tried, (Texts{"fold=+10", "fold=+20", ""}));
}

TEST(FairLimits, OnCornersAreThoseThatPanelsCanBeBuiltWithWhereHandlesAndFoldsStayAsTheyAre) {
  const EditStanding free = standing(10.0, 0.01, 3);
  const auto within = [&](const EditStanding& limited) {
    return find(free, {{kCorners, limited}}).limits;
  };
  EXPECT_EQ(within(standing(10.0, 0.059)), kCorners);
  EXPECT_EQ(within(standing(10.0, 0.07)), "");
  EXPECT_EQ(within(standing(11.0, 0.0)), "");
  EXPECT_EQ(within(standing(10.0, 0.0, 1)), "") << "it makes slivers, too";
  EXPECT_EQ(within(given_up(standing(10.0, 0.0))), "");
  const Found sharp = find(standing(26.0, 0.01, 1), {{kCorners, standing(26.0, 0.01)}},
                           {.way = kWay, .folds = false});
  EXPECT_EQ(sharp.limits, kCorners) << "no sharper than without it";
}

TEST(FairLimits, OnCornersStandBesideThatOnFolds) {
  const Found found =
      find(standing(60.0, 0.01, 5),
           {{"fold=+10", standing(10.0, 0.01, 2)}, {"fold=+10 " + kCorners, standing(10.0, 0.03)}});
  EXPECT_EQ(found.limits, "fold=+10 " + kCorners);
  EXPECT_EQ(found.tried, (Texts{"fold=+10", "fold=+10 " + kCorners}));
  const Found folds = find(standing(60.0, 0.01, 5), {{"fold=+10", standing(10.0, 0.01, 2)}});
  EXPECT_EQ(folds.limits, "fold=+10");
  EXPECT_EQ(folds.tried.back(), "fold=+10") << "the edit made last is that of the limits found";
}

}  // namespace
}  // namespace planish
