// SPDX-License-Identifier: MIT
#include "session.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/mesh_builders.hpp"
#include "support/open_session.hpp"

namespace planish {
namespace {

using testing::circular_of;
using testing::kWideAndSmall;
using testing::lift;
using testing::open_vault;

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

TEST(Session, AMeshBecomesCircularAndItsEditsKeepThat) {
  Session session = open_vault();
  const auto defect = [&] { return circular_of(session).excess; };
  EXPECT_GT(defect(), 0.05);
  ASSERT_EQ(session.planarise({.constraints = {read_constraint("circular")}}), std::nullopt);
  EXPECT_LE(defect(), 1e-9);
  EXPECT_GT(session.before_planarising().cols(), 0);
  ASSERT_EQ(session.set_options({.constraints = {read_constraint("circular")}}), std::nullopt);
  ASSERT_EQ(session.edit(EditMode::kSolve, lift(session, 0.3), 1.0), std::nullopt);
  EXPECT_FALSE(session.moved().empty());
  const Refusal unknown = session.planarise({.constraints = {read_constraint("round")}});
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

}  // namespace
}  // namespace planish
