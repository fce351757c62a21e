// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "session.hpp"
#include "support/open_session.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::circular_of;
using testing::lift;
using testing::open_vault;

TEST(SessionEdit, AnEditIsLocalAndFlat) {
  Session session = open_vault();
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.5), 1.0), std::nullopt);
  const ShapeReport& report = session.shape_report();
  EXPECT_LE(report.worst.mm_per_m, testing::kPromise);
  EXPECT_EQ(report.moved_vertices, static_cast<int>(session.moved().size()));
  EXPECT_GT(report.motion.raised, 0.4);  // the handle's own 0.5, less what it is short
  EXPECT_LE(report.motion.raised, report.max_displacement);
  EXPECT_GT(report.motion.slide, 0.0);
  int differing = 0;
  for (Eigen::Index v = 0; v < session.current().cols(); ++v) {
    if (session.current().col(v) != session.base().positions.col(v)) ++differing;
  }
  EXPECT_EQ(static_cast<std::size_t>(differing), session.moved().size());
  EXPECT_GT(differing, 0);
  EXPECT_LT(differing, session.base().vertex_count());
}

TEST(SessionEdit, ChangesCoverWhatMovedAndWhatMovedBack) {
  Session session = open_vault();
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.5), 1.0), std::nullopt);
  const std::size_t moved = session.moved().size();
  EXPECT_EQ(session.take_changes().size(), 4 * moved);
  EXPECT_TRUE(session.take_changes().empty());
  ASSERT_EQ(session.restore({}, {}, Positions(3, 0)), std::nullopt);
  EXPECT_TRUE(session.moved().empty());
  EXPECT_EQ(session.current(), session.base().positions);
  EXPECT_EQ(session.take_changes().size(), 4 * moved);
}

/// Along a path that jumps to another minimum at its end where the solve starts from nothing.
TEST(SessionEdit, ReleaseKeepsWhatTheDragShowed) {
  Session session;
  ASSERT_EQ(session.open_sample("vault", 20), std::nullopt);
  HandleEditOptions options;
  options.attraction = 1e4;
  options.reach = 6;
  options.keep_boundary = true;
  options.softness = 5.0;
  ASSERT_EQ(session.set_options(options), std::nullopt);
  const Eigen::Vector3d pull(-0.755, 0.664, -0.252);
  constexpr int kFrames = 23;  // no number of steps that a release tries
  EditTargets targets;
  for (int k = 1; k <= kFrames; ++k) {
    const Eigen::Vector3d part = pull * k / kFrames;
    targets.handles = {{81, session.base().positions.col(81) + part}};
    ASSERT_EQ(session.edit(EditMode::kDrag, targets, 10.0), std::nullopt);
  }
  const Positions shown = session.current();
  const auto differs = [&] {
    return (session.current() - shown).colwise().norm().maxCoeff() / pull.norm();
  };
  ASSERT_EQ(session.edit(EditMode::kRelease, targets, 10.0), std::nullopt);
  EXPECT_LT(differs(), 0.01);
  const Positions released = session.current();
  const ShapeReport& report = session.shape_report();
  targets.continuation = report.continuation;
  EXPECT_GT(targets.continuation, 0);
  EXPECT_FALSE(report.lower_at_once);

  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 10.0), std::nullopt);
  EXPECT_EQ(session.current(), released) << "bit by bit, from the recipe alone";
  targets.continuation = 0;
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 10.0), std::nullopt);
  EXPECT_GT(differs(), 0.1) << "at once is another minimum: else this tests nothing";
  ASSERT_EQ(session.edit(EditMode::kRelease, targets, 10.0), std::nullopt);
  EXPECT_GT(differs(), 0.1) << "nothing was dragged since";

  EditTargets before = targets;  // a pointer's last move, whose frame was not drawn
  for (int k = 1; k < kFrames; ++k) {
    const Eigen::Vector3d part = pull * k / kFrames;
    before.handles = {{81, session.base().positions.col(81) + part}};
    ASSERT_EQ(session.edit(EditMode::kDrag, before, 10.0), std::nullopt);
  }
  ASSERT_EQ(session.edit(EditMode::kRelease, targets, 10.0), std::nullopt);
  EXPECT_LT(differs(), 0.01);
}

/// While others are tried, frames of a drag and solves.
TEST(SessionEdit, AKeptEditIsShownAgainWithItsReport) {
  Session session = open_vault();
  session.show_kept();
  EXPECT_EQ(session.current(), session.base().positions) << "nothing was kept";
  for (const EditMode mode : {EditMode::kDrag, EditMode::kSolve}) {
    ASSERT_EQ(session.edit(mode, lift(session, 0.1), 10.0), std::nullopt);
    session.keep_edit();
    const Positions kept = session.current();
    const ShapeReport report = session.shape_report();
    ASSERT_EQ(session.edit(mode, lift(session, 0.5), 10.0), std::nullopt);
    ASSERT_NE(session.current(), kept);
    (void)session.take_changes();
    session.show_kept();
    EXPECT_EQ(session.current(), kept);
    EXPECT_EQ(session.shape_report().handle_error, report.handle_error);
    EXPECT_EQ(session.shape_report().solve.objective.total(), report.solve.objective.total());
    EXPECT_FALSE(session.take_changes().empty());
  }
  ASSERT_EQ(session.open_sample("vault", 9), std::nullopt);
  session.show_kept();
  EXPECT_EQ(session.current(), session.base().positions) << "it was an edit of another mesh";
}

TEST(SessionEdit, SupportsHoldInEveryEditFromThereOn) {
  Session session = open_vault();
  const int rim = 8;  // in the middle of a side
  EditTargets targets = lift(session, 0.6);
  targets.handles.push_back(
      {rim, session.base().positions.col(rim) + Eigen::Vector3d(0.3, 0.2, 0.4)});
  const auto leaves_level = [&] {
    return session.current()(2, rim) != session.base().positions(2, rim);
  };
  ASSERT_EQ(session.set_supports({"level=z:boundary"}), std::nullopt);
  for (const EditMode mode : {EditMode::kDrag, EditMode::kRelease, EditMode::kSolve}) {
    ASSERT_EQ(session.edit(mode, targets, 10.0), std::nullopt);
    EXPECT_FALSE(leaves_level());
  }
  ASSERT_EQ(session.explore({.dimension = 2}), std::nullopt);
  ASSERT_EQ(session.vary(Eigen::Vector2d(0.3, 0.3)), std::nullopt);
  ASSERT_EQ(session.make_exact(), std::nullopt);
  EXPECT_FALSE(leaves_level()) << "variations leave the boundary where the edit put it";
  ASSERT_EQ(session.set_supports({}), std::nullopt);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 10.0), std::nullopt);
  EXPECT_TRUE(leaves_level());
}

TEST(SessionEdit, RefusesSupportsThatTheBaseHasNot) {
  Session session = open_vault();
  EXPECT_NE(session.set_supports({"roof:boundary"}), std::nullopt);
  ASSERT_EQ(session.set_supports({"plane=0,0,1,99:3"}), std::nullopt)
      << "the base is not asked yet";
  const Refusal refusal = session.edit(EditMode::kSolve, lift(session, 0.3), 1.0);
  ASSERT_NE(refusal, std::nullopt);
  EXPECT_NE(refusal->find("away from it"), std::string::npos) << *refusal;
  ASSERT_EQ(session.set_supports({"level:boundary"}), std::nullopt);
  HandleEditOptions paper;
  paper.engine = Engine::kAugmentedLagrangian;
  ASSERT_EQ(session.set_options(paper), std::nullopt);
  EXPECT_NE(session.edit(EditMode::kSolve, lift(session, 0.3), 1.0), std::nullopt);
}

/// Degrees, as the report says it.
double sharpest_fold_of(const Session& session) { return session.shape_report().fold.degrees; }

/// What a design of it could not say is not done either.
TEST(SessionEdit, ThePapersEngineKnowsNoKeepOutsAndGoesAtOnce) {
  Session session = open_vault();
  HandleEditOptions paper;
  paper.engine = Engine::kAugmentedLagrangian;
  ASSERT_EQ(session.set_options(paper), std::nullopt);
  EditTargets targets = lift(session, 0.5);
  targets.continuation = 16;
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 1.0), std::nullopt);
  EXPECT_EQ(session.shape_report().continuation, 0);
  paper.keep_outs = {{.kind = KeepOut::Kind::kAbove, .numbers = {1e3}}};
  ASSERT_EQ(session.set_options(paper), std::nullopt);
  const Refusal refusal = session.edit(EditMode::kSolve, targets, 1.0);
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->find("knows no keep-outs"), std::string::npos) << *refusal;
}

TEST(SessionEdit, ThePapersEngineSaysThatItKnowsNoPanelsThatStayBent) {
  Session session = open_vault();
  HandleEditOptions paper;
  paper.engine = Engine::kAugmentedLagrangian;
  paper.tolerance = 25.0;
  paper.keep_bends = true;
  ASSERT_EQ(session.set_options(paper), std::nullopt);
  const Refusal refusal = session.edit(EditMode::kSolve, lift(session, 0.5), 1.0);
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->find("knows no panels that stay bent"), std::string::npos) << *refusal;
}

TEST(SessionEdit, LimitsHoldInEveryEditFromThereOn) {
  Session session = open_vault();
  HandleEditOptions soft;
  soft.softness = 5.0;
  soft.reach = 6;
  ASSERT_EQ(session.set_options(soft), std::nullopt);
  const EditTargets targets = lift(session, 1.5);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 10.0), std::nullopt);
  ASSERT_GT(sharpest_fold_of(session), 20.1);
  EXPECT_TRUE(session.shape_report().solve.bounds.empty());
  HandleEditOptions limited = soft;
  limited.bounds = {read_item<StatedLimit>("fold=20"), read_item<StatedLimit>("angle=45:135")};
  ASSERT_EQ(session.set_options(limited), std::nullopt);
  for (int frame = 1; frame <= 8; ++frame) {
    ASSERT_EQ(session.edit(EditMode::kDrag, lift(session, 0.1 * frame), 10.0), std::nullopt);
    EXPECT_LE(sharpest_fold_of(session), 20.1);
    EXPECT_FALSE(session.moved().empty()) << frame;
  }
  for (const EditMode mode : {EditMode::kRelease, EditMode::kSolve}) {
    ASSERT_EQ(session.edit(mode, targets, 10.0), std::nullopt);
    EXPECT_LE(sharpest_fold_of(session), 20.1);
    EXPECT_FALSE(session.moved().empty());
  }
  const std::vector<BoundStanding>& bounds = session.shape_report().solve.bounds;
  ASSERT_EQ(bounds.size(), 2U);
  for (const BoundStanding& bound : bounds) {
    if (bound.name == "fold") {
      EXPECT_FALSE(bound.binding.empty()) << "the panels that the limit holds back";
    } else {
      EXPECT_EQ(bound.name, "angle");
    }
  }
  ASSERT_EQ(session.set_options(soft), std::nullopt);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 10.0), std::nullopt);
  EXPECT_GT(sharpest_fold_of(session), 20.1);
}

TEST(SessionEdit, LimitsThatCannotBeAreRefusedInWordsAndVariationsKeepTheOthers) {
  Session session = open_vault();
  const auto says = [](const Refusal& refusal, const char* words) {
    return refusal && refusal->find(words) != std::string::npos;
  };
  const auto limit = [&](const char* text) {
    return session.set_options({.bounds = {read_item<StatedLimit>(text)}});
  };
  EXPECT_TRUE(says(limit("flat=20"), "one of fold=MAX"));
  EXPECT_TRUE(says(limit("angle=120:60"), "must be less than the second"));
  ASSERT_EQ(limit("fold=+5"), std::nullopt);
  EXPECT_TRUE(says(limit("fold=900"), "at most 180 degrees"));
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.5), 10.0), std::nullopt);
  ASSERT_LE(session.shape_report().fold_growth, 5.1);
  ASSERT_EQ(session.explore({.dimension = 2}), std::nullopt);
  ASSERT_EQ(session.vary(Eigen::Vector2d(1.5, -1.5)), std::nullopt);
  EXPECT_GT(session.shape_report().fold_growth, 5.1) << "the sliders alone keep no limit";
  ASSERT_EQ(session.make_exact(), std::nullopt);
  EXPECT_LE(session.shape_report().fold_growth, 5.1);
  EXPECT_EQ(session.shape_report().solve.status, SolveStatus::kNearestConfined);
  ASSERT_EQ(session.shape_report().solve.bounds.size(), 1u);
  EXPECT_FALSE(session.shape_report().solve.bounds.front().binding.empty());
}

TEST(SessionEdit, KindsAreKeptByEveryEditOfAMeshThatKeepsThem) {
  Session session;
  ASSERT_EQ(session.open_sample("dome", testing::kSide), std::nullopt);
  const KindSpread circular = circular_of(session);
  EXPECT_LE(circular.excess, 1e-9);
  EXPECT_LE(circular.median, circular.worst);
  const auto keep = [&](const char* kind) {
    return session.set_options({.constraints = {read_constraint(kind)}});
  };
  EXPECT_NE(keep("round"), std::nullopt);
  EXPECT_NE(keep("circular:0"), std::nullopt);
  ASSERT_EQ(keep("circular"), std::nullopt);
  const auto worst = [&] {
    const std::vector<KindViolation>& kept = session.shape_report().solve.violations;
    EXPECT_EQ(kept.back().kind, "circular");
    return kept.back().after_max;
  };
  for (const EditMode mode : {EditMode::kDrag, EditMode::kRelease, EditMode::kSolve}) {
    ASSERT_EQ(session.edit(mode, lift(session, 0.3), 10.0), std::nullopt);
    EXPECT_FALSE(session.moved().empty());
    EXPECT_LE(worst(), 1e-8);
  }
  ASSERT_EQ(session.explore({.dimension = 2}), std::nullopt);
  ASSERT_EQ(session.vary(Eigen::Vector2d(0.2, -0.1)), std::nullopt);
  EXPECT_NE(session.explore({.dimension = 2}), std::nullopt) << "not circular as the sliders go";
  ASSERT_EQ(session.make_exact(), std::nullopt);
  EXPECT_LE(worst(), 1e-8);
  ASSERT_EQ(session.set_options({}), std::nullopt);
  EXPECT_EQ(session.explore({.dimension = 2}), std::nullopt);
}

TEST(SessionEdit, RefusesKindsThatTheBaseDoesNotKeep) {
  Session session = open_vault();
  const HandleEditOptions circular{.constraints = {read_constraint("circular")}};
  ASSERT_EQ(session.set_options(circular), std::nullopt) << "the base is not asked yet";
  const Refusal refusal = session.edit(EditMode::kSolve, lift(session, 0.3), 1.0);
  ASSERT_NE(refusal, std::nullopt);
  EXPECT_NE(refusal->find("the base mesh is not circular"), std::string::npos) << *refusal;
  ASSERT_EQ(session.set_options({}), std::nullopt);
  EXPECT_EQ(session.edit(EditMode::kSolve, lift(session, 0.3), 1.0), std::nullopt);
}

TEST(SessionEdit, ARefusedEditKeepsTheLastOne) {
  Session session = open_vault();
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.5), 1.0), std::nullopt);
  const Positions before = session.current();
  EXPECT_NE(session.edit(EditMode::kSolve, {.handles = {{-1, {0, 0, 0}}}, .pins = {}}, 1.0),
            std::nullopt);
  HandleEditOptions nonsense;
  nonsense.attraction = -1.0;
  EXPECT_NE(session.set_options(nonsense), std::nullopt);
  EXPECT_EQ(session.current(), before);
}

}  // namespace
}  // namespace planish
