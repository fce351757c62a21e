// SPDX-License-Identifier: MIT
#include "session.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/mesh_builders.hpp"

namespace planish {
namespace {

constexpr double kToleranceMmPerM = 1e-6;

Session open_vault() {
  Session session;
  EXPECT_EQ(session.open_sample("vault", 17), std::nullopt);
  return session;
}

/// The middle of the 17 × 17 vault, raised.
EditTargets lift(const Session& session, double height) {
  constexpr int kMiddle = 8 * 17 + 8;
  Eigen::Vector3d target = session.base().positions.col(kMiddle);
  target.z() += height;
  return {.handles = {{kMiddle, target}}, .pins = {}};
}

TEST(Session, RefusesBeforeAMeshIsOpen) {
  Session session;
  EXPECT_NE(session.edit(EditMode::kSolve, {}, 1.0), std::nullopt);
  EXPECT_NE(session.explore({}), std::nullopt);
  EXPECT_NE(session.vary(Eigen::VectorXd::Zero(1)), std::nullopt);
}

TEST(Session, ARefusedFileLeavesTheSessionAsItWas) {
  Session session = open_vault();
  const Mesh before = session.base();
  const Refusal refusal = session.open_file("v 0 0 0\nf 1 2 3\n", "obj");
  ASSERT_NE(refusal, std::nullopt);
  EXPECT_NE(refusal->find("line 2"), std::string::npos) << *refusal;
  EXPECT_NE(session.open_file("", "dwg"), std::nullopt);
  EXPECT_NE(session.open_sample("castle", 9), std::nullopt);
  EXPECT_TRUE(testing::same_bits(session.base().positions, before.positions));
  EXPECT_EQ(session.base().face_vertices, before.face_vertices);
}

/// A wide panel that is far out of flat in millimetres, a small one that is so in mm/m.
constexpr std::string_view kWideAndSmall =
    "v 0 0 0\nv 20 0 0\nv 20 20 0\nv 0 20 1\nf 1 2 3 4\n"
    "v 30 0 0\nv 31 0 0\nv 31 1 0\nv 30 1 0.2\nf 5 6 7 8\n";

TEST(Session, BothFiguresOfTheWorstPanelAreOfOnePanel) {
  Session session;
  ASSERT_EQ(session.open_file(kWideAndSmall, "obj"), std::nullopt);
  const Positions& base = session.base().positions;
  const FacePlanarity wide = face_planarity(base, session.base().face(0));
  const FacePlanarity small = face_planarity(base, session.base().face(1));
  const WorstPanel opened = session.mesh_report().worst;
  EXPECT_EQ(opened.gap, small.gap);
  EXPECT_EQ(opened.mm_per_m, small.mm_per_m);
  // The same of a design: now the wide panel is worse in both.
  const Positions lifted = base.col(3) + Eigen::Vector3d(0, 0, 9);
  ASSERT_EQ(session.restore({}, {3}, lifted), std::nullopt);
  const FacePlanarity wider = face_planarity(session.current(), session.base().face(0));
  const WorstPanel shown = session.shape_report().worst;
  EXPECT_EQ(shown.gap, wider.gap);
  EXPECT_EQ(shown.mm_per_m, wider.mm_per_m);
  EXPECT_GT(wider.mm_per_m, wide.mm_per_m);
}

TEST(Session, SaysByHowMuchPlanarisingMovedThePoints) {
  Session session;
  ASSERT_EQ(session.open_file(kWideAndSmall, "obj"), std::nullopt);
  const Positions opened = session.base().positions;
  const MeshReport before = session.mesh_report();
  EXPECT_EQ(before.planarised_vertices, 0);
  EXPECT_EQ(before.planarised_most, 0.0);
  EXPECT_EQ(session.before_planarising().cols(), 0);
  ASSERT_EQ(session.planarise(), std::nullopt);
  const MeshReport after = session.mesh_report();
  EXPECT_EQ(after.planarised_vertices, moved_vertex_count(opened, session.base().positions));
  EXPECT_EQ(after.planarised_most, (opened - session.base().positions).colwise().norm().maxCoeff());
  EXPECT_GT(after.planarised_most, 0.1);
  EXPECT_EQ(session.before_planarising(), opened);
  // Again, now that there is nothing to do: it still tells of the file.
  ASSERT_EQ(session.planarise(), std::nullopt);
  EXPECT_EQ(session.mesh_report().planarised_vertices, after.planarised_vertices);
  EXPECT_EQ(session.mesh_report().planarised_most, after.planarised_most);
  ASSERT_EQ(session.open_sample("vault", 9), std::nullopt);
  EXPECT_EQ(session.before_planarising().cols(), 0);
}

TEST(Session, WhatAMeshBecomesDependsOnTheFileAndTheLastChoiceAlone) {
  Session twice;
  ASSERT_EQ(twice.open_file(kWideAndSmall, "obj"), std::nullopt);
  ASSERT_EQ(twice.planarise({.fairness_weight = 100.0}), std::nullopt);
  const Positions fair = twice.base().positions;
  ASSERT_EQ(twice.planarise(kNearestFlat), std::nullopt);
  Session once;
  ASSERT_EQ(once.open_file(kWideAndSmall, "obj"), std::nullopt);
  ASSERT_EQ(once.planarise(kNearestFlat), std::nullopt);
  EXPECT_EQ(twice.base().positions, once.base().positions);
  EXPECT_NE(twice.base().positions, fair);
}

TEST(Session, TakesAFlatMeshThatAnotherSessionFound) {
  Session other;
  ASSERT_EQ(other.open_file(kWideAndSmall, "obj"), std::nullopt);
  ASSERT_EQ(other.planarise(), std::nullopt);
  Session session;
  ASSERT_EQ(session.open_file(kWideAndSmall, "obj"), std::nullopt);
  const Positions opened = session.base().positions;
  ASSERT_EQ(session.take_planarised(other.base().positions), std::nullopt);
  EXPECT_EQ(session.base().positions, other.base().positions);
  EXPECT_EQ(session.before_planarising(), opened);
  EXPECT_EQ(session.mesh_report().planarised_most, other.mesh_report().planarised_most);
  EXPECT_NE(session.take_planarised(Positions::Zero(3, 2)), std::nullopt);
  EXPECT_EQ(session.base().positions, other.base().positions);
  // Another choice still begins with the file.
  ASSERT_EQ(session.planarise(kNearestFlat), std::nullopt);
  EXPECT_EQ(session.before_planarising(), opened);
}

/// How far the base is from circular panels.
KindSpread circular_of(const Session& session) {
  for (const KindSpread& spread : session.mesh_report().kinds) {
    if (spread.kind == "circular") return spread;
  }
  ADD_FAILURE() << "no panel of this mesh could miss its circle";
  return {};
}

TEST(Session, AMeshBecomesCircularAndItsEditsKeepThat) {
  Session session = open_vault();
  const auto defect = [&] { return circular_of(session).excess; };
  EXPECT_GT(defect(), 0.05);
  ASSERT_EQ(session.planarise({.constraints = read_constraints("circular")}), std::nullopt);
  EXPECT_LE(defect(), 1e-9);
  EXPECT_GT(session.before_planarising().cols(), 0);
  ASSERT_EQ(session.set_options({.constraints = read_constraints("circular")}), std::nullopt);
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.3), 1.0), std::nullopt);
  EXPECT_FALSE(session.moved().empty());
  const Refusal unknown = session.planarise({.constraints = read_constraints("round")});
  ASSERT_NE(unknown, std::nullopt);
  EXPECT_NE(unknown->find("circular, conical"), std::string::npos) << *unknown;
}

TEST(Session, AFlatBaseGivesBothFiguresOfThePanelThatIsWorstInMmPerM) {
  Session session;
  ASSERT_EQ(session.open_file(kWideAndSmall, "obj"), std::nullopt);
  ASSERT_EQ(session.planarise(), std::nullopt);
  Positions bent = session.base().positions(Eigen::all, std::vector<int>{3, 7});
  bent.row(2) += Eigen::RowVector2d(1.0, 0.2);
  ASSERT_EQ(session.restore({}, {3, 7}, bent), std::nullopt);
  const FacePlanarity small = face_planarity(session.current(), session.base().face(1));
  const WorstPanel shown = session.shape_report().worst;
  EXPECT_EQ(shown.gap, small.gap);
  EXPECT_EQ(shown.mm_per_m, small.mm_per_m);
}

TEST(Session, AnEditIsLocalAndFlat) {
  Session session = open_vault();
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.5), 1.0), std::nullopt);
  const ShapeReport& report = session.shape_report();
  EXPECT_LE(report.worst.mm_per_m, kToleranceMmPerM);
  EXPECT_EQ(report.moved_vertices, static_cast<int>(session.moved().size()));
  int differing = 0;
  for (Eigen::Index v = 0; v < session.current().cols(); ++v) {
    if (session.current().col(v) != session.base().positions.col(v)) ++differing;
  }
  EXPECT_EQ(static_cast<std::size_t>(differing), session.moved().size());
  EXPECT_GT(differing, 0);
  EXPECT_LT(differing, session.base().vertex_count());
}

TEST(Session, ChangesCoverWhatMovedAndWhatMovedBack) {
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

TEST(Session, ARestoredDesignIsTheSameToTheLastBit) {
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

/// Along a path that jumps to another minimum at its end where the solve starts from nothing.
TEST(Session, ReleaseKeepsWhatTheDragShowed) {
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

TEST(Session, SupportsHoldInEveryEditFromThereOn) {
  Session session = open_vault();
  const int rim = 8;  // in the middle of a side
  EditTargets targets = lift(session, 0.6);
  targets.handles.push_back(
      {rim, session.base().positions.col(rim) + Eigen::Vector3d(0.3, 0.2, 0.4)});
  const auto leaves_level = [&] {
    return session.current()(2, rim) != session.base().positions(2, rim);
  };
  ASSERT_EQ(session.set_supports("level=z:boundary\n"), std::nullopt);
  for (const EditMode mode : {EditMode::kDrag, EditMode::kRelease, EditMode::kSolve}) {
    ASSERT_EQ(session.edit(mode, targets, 10.0), std::nullopt);
    EXPECT_FALSE(leaves_level());
  }
  ASSERT_EQ(session.explore({.dimension = 2}), std::nullopt);
  ASSERT_EQ(session.vary(Eigen::Vector2d(0.3, 0.3)), std::nullopt);
  ASSERT_EQ(session.make_exact(), std::nullopt);
  EXPECT_FALSE(leaves_level()) << "variations leave the boundary where the edit put it";
  ASSERT_EQ(session.set_supports(""), std::nullopt);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 10.0), std::nullopt);
  EXPECT_TRUE(leaves_level());
}

TEST(Session, RefusesSupportsThatTheBaseHasNot) {
  Session session = open_vault();
  EXPECT_NE(session.set_supports("roof:boundary"), std::nullopt);
  ASSERT_EQ(session.set_supports("plane=0,0,1,99:3"), std::nullopt) << "the base is not asked yet";
  const Refusal refusal = session.edit(EditMode::kSolve, lift(session, 0.3), 1.0);
  ASSERT_NE(refusal, std::nullopt);
  EXPECT_NE(refusal->find("away from it"), std::string::npos) << *refusal;
  ASSERT_EQ(session.set_supports("level:boundary"), std::nullopt);
  HandleEditOptions paper;
  paper.engine = Engine::kAugmentedLagrangian;
  ASSERT_EQ(session.set_options(paper), std::nullopt);
  EXPECT_NE(session.edit(EditMode::kSolve, lift(session, 0.3), 1.0), std::nullopt);
}

/// Degrees, as the report says it.
double sharpest_fold_of(const Session& session) { return session.shape_report().fold.degrees; }

TEST(Session, LimitsHoldInEveryEditFromThereOn) {
  Session session = open_vault();
  HandleEditOptions soft;
  soft.softness = 5.0;
  soft.reach = 6;
  ASSERT_EQ(session.set_options(soft), std::nullopt);
  const EditTargets targets = lift(session, 1.2);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 10.0), std::nullopt);
  ASSERT_GT(sharpest_fold_of(session), 20.1);
  EXPECT_TRUE(session.shape_report().solve.bounds.empty());
  HandleEditOptions limited = soft;
  limited.bounds = read_limits("fold=20\nangle=45:135\n");
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

TEST(Session, LimitsThatCannotBeAreRefusedInWordsAndVariationsKeepTheOthers) {
  Session session = open_vault();
  const auto says = [](const Refusal& refusal, const char* words) {
    return refusal && refusal->find(words) != std::string::npos;
  };
  const auto limit = [&](const char* text) {
    return session.set_options({.bounds = read_limits(text)});
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

TEST(Session, KindsAreKeptByEveryEditOfAMeshThatKeepsThem) {
  Session session;
  ASSERT_EQ(session.open_sample("dome", 17), std::nullopt);
  const KindSpread circular = circular_of(session);
  EXPECT_LE(circular.excess, 1e-9);
  EXPECT_LE(circular.median, circular.worst);
  const auto keep = [&](const char* kinds) {
    return session.set_options({.constraints = read_constraints(kinds)});
  };
  EXPECT_NE(keep("round"), std::nullopt);
  EXPECT_NE(keep("circular:0"), std::nullopt);
  ASSERT_EQ(keep("circular\n"), std::nullopt);
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
  ASSERT_EQ(keep(""), std::nullopt);
  EXPECT_EQ(session.explore({.dimension = 2}), std::nullopt);
}

TEST(Session, RefusesKindsThatTheBaseDoesNotKeep) {
  Session session = open_vault();
  const HandleEditOptions circular{.constraints = read_constraints("circular")};
  ASSERT_EQ(session.set_options(circular), std::nullopt) << "the base is not asked yet";
  const Refusal refusal = session.edit(EditMode::kSolve, lift(session, 0.3), 1.0);
  ASSERT_NE(refusal, std::nullopt);
  EXPECT_NE(refusal->find("the base mesh is not circular"), std::string::npos) << *refusal;
  ASSERT_EQ(session.set_options({}), std::nullopt);
  EXPECT_EQ(session.edit(EditMode::kSolve, lift(session, 0.3), 1.0), std::nullopt);
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

TEST(Session, ReplaysADesignToTheBitsOfItsSteps) {
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
  EXPECT_EQ(a.solve.iterations, b.solve.iterations);
  // The sliders go on from where the design has them.
  const Eigen::Vector2d further(0.5, -0.4);
  ASSERT_EQ(by_steps.vary(further), std::nullopt);
  ASSERT_EQ(replayed.vary(further), std::nullopt);
  EXPECT_TRUE(testing::same_bits(replayed.current(), by_steps.current()));
}

TEST(Session, ARefusedReplayLeavesTheSessionAsItWas) {
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

TEST(Session, ADesignWithoutAnEditIsItsBase) {
  Session session;
  ASSERT_EQ(session.open_file(kWideAndSmall, "obj"), std::nullopt);
  EXPECT_EQ(session.replay({}, mesh_hash(session.base())), std::nullopt) << "flat or not";
  EXPECT_TRUE(session.moved().empty());
}

TEST(Session, RefusesADesignOfAnotherMesh) {
  Session session = open_vault();
  EXPECT_NE(session.restore({}, {9999}, Positions::Zero(3, 1)), std::nullopt);
  EXPECT_NE(session.restore({}, {3, 2}, Positions::Zero(3, 2)), std::nullopt);
  EXPECT_NE(session.restore({}, {3}, Positions::Zero(3, 2)), std::nullopt);
  EXPECT_TRUE(session.moved().empty());
}

TEST(Session, ARefusedEditKeepsTheLastOne) {
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

TEST(Session, VariationsOutliveARestoreThatKeepsThem) {
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

TEST(Session, DisplayCoordinatesKeepTheirDigitsFarFromTheOrigin) {
  Session session;
  const std::string far =
      "v 500000 6200000 100\nv 500001 6200000 100\nv 500001 6200001 100\n"
      "v 500000 6200001 100\nf 1 2 3 4\n";
  ASSERT_EQ(session.open_file(far, "obj"), std::nullopt);
  const std::vector<float> display = session.display_base();
  const auto [low, high] = std::minmax_element(display.begin(), display.end());
  EXPECT_NEAR(*high - *low, 10.0 / std::sqrt(2.0), 1e-5);
}

TEST(Session, UnknownFormatsAreNotWritten) { EXPECT_EQ(open_vault().write("dwg"), std::nullopt); }

TEST(Session, AProjectedVariationIsTheExactOneAndChangesNothing) {
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

TEST(Session, TheReportSpeaksOfTheDesignShown) {
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

TEST(Session, AVariationKeepsThePartsOfTheEditThatNoVectorMoves) {
  Session session = open_vault();
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.5), 1.0), std::nullopt);
  ASSERT_EQ(session.explore({.dimension = 1, .reach = 0}), std::nullopt);
  const Positions edited = session.current();
  ASSERT_EQ(session.vary(Eigen::VectorXd::Zero(1)), std::nullopt);
  EXPECT_EQ(session.current(), edited);
}

}  // namespace
}  // namespace planish
