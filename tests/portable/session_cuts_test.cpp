// SPDX-License-Identifier: MIT
/// A session's base with cuts: what its edits start from, what its designs hold, and how it is made
/// flat, or another, again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "planish/design/cut_base.hpp"
#include "session.hpp"
#include "support/mesh_builders.hpp"
#include "support/open_session.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::lift;
using testing::open_vault;

constexpr double kTolerance = 1e-6;
const std::string kLines = "strip=81-82@0.25\ncorner=66:71";

std::vector<Cut> cuts_of_lines() {
  return {StripCut{81, 82, 0.25}, CornerCut{66, 71, CornerCut::kShare}};
}

Session cut_vault() {
  Session session = open_vault();
  EXPECT_EQ(session.set_cuts(kLines, kTolerance), std::nullopt);
  return session;
}

/// The recipe of the session's edit, done on the file by the core.
Replay replay_of(const Session& session, EditTargets targets, const std::string& support) {
  Design design;
  design.source = SampleSource{"vault", testing::kSide};
  design.cuts = cuts_of_lines();
  design.targets = std::move(targets);
  if (!support.empty()) design.targets.supports = {*parse_point_support(support)};
  design.result = mark_of(session.base(), session.current());
  auto result = replay(design);
  EXPECT_TRUE(std::holds_alternative<Replay>(result));
  return std::get<Replay>(std::move(result));
}

TEST(SessionCuts, TheBaseIsWhatTheyLeave) {
  const Session whole = open_vault(), session = cut_vault();
  const auto cut = std::get<CutMesh>(cut_mesh(whole.base(), cuts_of_lines()));
  EXPECT_TRUE(testing::same_bits(session.base(), cut.mesh));
  EXPECT_TRUE(testing::same_bits(session.uncut(), whole.base()));
  EXPECT_EQ(session.panel_parents(), cut.parents);
  EXPECT_TRUE(whole.panel_parents().empty());
}

TEST(SessionCuts, AnEditIsThatOfTheRecipe) {
  Session session = cut_vault();
  // A line of the file's mesh that a cut divided.
  for (const std::string support : {"", "polyline:81,82,83", "outline:boundary"}) {
    SCOPED_TRACE(support);
    if (support == "outline:boundary" && !testing::is_night()) continue;  // CutDesigns has them
    const auto supports = support.empty() ? std::vector<std::string>() : std::vector{support};
    ASSERT_EQ(session.set_supports(supports), std::nullopt);
    const EditTargets targets = lift(session, 0.5);
    ASSERT_EQ(session.edit(EditMode::kSolve, targets, 1.0), std::nullopt);
    EXPECT_TRUE(replay_of(session, targets, support).verified);
  }
}

TEST(SessionCuts, ReplaysADesignThatHasThem) {
  Session session = cut_vault(), whole = open_vault();
  Design design;
  design.cuts = cuts_of_lines();
  design.targets = lift(session, 0.5);
  design.targets.supports = {*parse_point_support("polyline:81,82,83")};
  const std::uint32_t hash = mesh_hash(whole.base());
  ASSERT_EQ(session.replay(design, hash), std::nullopt) << "the hash is that of the file's mesh";
  const EditTargets targets = lift(whole, 0.5);
  EXPECT_TRUE(replay_of(session, targets, "polyline:81,82,83").verified);
  const Refusal refusal = whole.replay(design, hash);
  ASSERT_NE(refusal, std::nullopt);
  EXPECT_EQ(*refusal, "The design has other cuts.");
}

TEST(SessionCuts, OthersTakeTheirPlace) {
  Session session = cut_vault();
  ASSERT_EQ(session.set_cuts("refine=3", kTolerance), std::nullopt);
  const Session whole = open_vault();
  const auto cut = std::get<CutMesh>(cut_mesh(whole.base(), {RefineCut{{3}, false}}));
  EXPECT_TRUE(testing::same_bits(session.base(), cut.mesh));
  ASSERT_EQ(session.set_cuts("", kTolerance), std::nullopt);
  EXPECT_TRUE(testing::same_bits(session.base(), whole.base()));
}

TEST(SessionCuts, AreMadeAgainOnceTheMeshIsFlat) {
  Session session, whole;
  for (Session* one : {&session, &whole}) {
    ASSERT_EQ(one->open_file(testing::kWideAndSmall, "obj"), std::nullopt);
  }
  ASSERT_EQ(session.set_cuts("corner=1:4", kTolerance), std::nullopt);
  ASSERT_EQ(session.planarise(), std::nullopt);
  ASSERT_EQ(whole.planarise(), std::nullopt);
  EXPECT_TRUE(testing::same_bits(session.uncut(), whole.base()));
  const auto cut = std::get<CutMesh>(cut_mesh(whole.base(), {CornerCut{1, 4, 1.0}}));
  EXPECT_TRUE(testing::same_bits(session.base(), cut.mesh));
  EXPECT_EQ(session.mesh_report().planarised_vertices, whole.mesh_report().planarised_vertices);
  // Found elsewhere: without cuts.
  ASSERT_EQ(session.take_planarised(whole.base().positions), std::nullopt);
  EXPECT_TRUE(testing::same_bits(session.base(), cut.mesh));
}

TEST(SessionCuts, SaysWhatIsWrong) {
  Session session = open_vault();
  EXPECT_EQ(*session.set_cuts("split=900:1,2", kTolerance),
            "Cuts: split=900:1,2: there is no panel 900: panels are 0 to 143.");
  EXPECT_NE(session.set_cuts("saw=1", kTolerance)->find("is no cut"), std::string::npos);
  ASSERT_EQ(session.set_symmetry("x", kTolerance), std::nullopt);
  EXPECT_NE(session.set_cuts("corner=3:3", kTolerance), std::nullopt) << "without its image";
}

TEST(SessionCuts, RefusedLeavesThoseThatWereThere) {
  Session session = cut_vault();
  const Mesh cut = session.base();
  EXPECT_NE(session.set_cuts(kLines + "\nsplit=900:1,2", kTolerance), std::nullopt);
  EXPECT_TRUE(testing::same_bits(session.base(), cut));
}

TEST(SessionCuts, ATrialHasTheNewSidesAndMakesNothing) {
  Session session = open_vault();
  const Mesh whole = session.base();
  struct Case {
    std::string text;
    std::size_t sides;
  };
  // A side between two parts is listed by both; a strip of 12 quads gets one in each.
  for (const auto& [text, sides] : {Case{"corner=66:71", 2}, Case{"strip=81-82@0.25", 24},
                                    Case{"refine=3", 8}, Case{"split=0:0,14", 2}}) {
    const CutTrial trial = session.try_cut(text, kTolerance);
    EXPECT_EQ(trial.problem, "") << text;
    EXPECT_EQ(trial.lines.size(), 6 * sides) << text;
  }
  EXPECT_EQ(session.try_cut("split=900:1,2", kTolerance).problem,
            "split=900:1,2: there is no panel 900: panels are 0 to 143.");
  EXPECT_TRUE(testing::same_bits(session.base(), whole));
}

TEST(SessionCuts, ATrialUnderASymmetryHasTheImages) {
  Session session = open_vault();
  ASSERT_EQ(session.set_symmetry("x", kTolerance), std::nullopt);
  const CutTrial trial = session.try_cut("corner=0:0", kTolerance);
  EXPECT_EQ(trial.problem, "");
  EXPECT_EQ(std::count(trial.cuts.begin(), trial.cuts.end(), '\n'), 1) << trial.cuts;
  EXPECT_EQ(session.set_cuts(trial.cuts, kTolerance), std::nullopt);
}

TEST(SessionCuts, ATrialLiesOnTheDesignShown) {
  Session session = open_vault();
  EditTargets targets = lift(session, 0.5);
  const int lifted = targets.handles.front().vertex;
  ASSERT_EQ(session.edit(EditMode::kSolve, std::move(targets), 1.0), std::nullopt);
  const std::vector<float> base = session.display_base();
  const CutTrial trial = session.try_cut(
      "strip=" + std::to_string(lifted) + "-" + std::to_string(lifted + 1) + "@0.5", kTolerance);
  ASSERT_EQ(trial.problem, "");
  // Half way along the side the new point has half of what its ends have moved by.
  const std::vector<float> changes = session.take_changes();
  std::vector<float> shown = base;
  for (std::size_t k = 0; k + 3 < changes.size(); k += 4) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      shown[3 * static_cast<std::size_t>(changes[k]) + axis] = changes[k + 1 + axis];
    }
  }
  const auto at = static_cast<std::size_t>(lifted);
  float nearest = 1e9F;
  for (std::size_t k = 0; k < trial.lines.size(); k += 3) {
    float away = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float middle = 0.5F * (shown[3 * at + axis] + shown[3 * at + 3 + axis]);
      away += std::abs(trial.lines[k + axis] - middle);
    }
    nearest = std::min(nearest, away);
  }
  EXPECT_LT(nearest, 1e-5F);
}

}  // namespace
}  // namespace planish
