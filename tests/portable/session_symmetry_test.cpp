// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <utility>
#include <variant>

#include "planish/io/obj.hpp"
#include "session.hpp"
#include "support/mesh_builders.hpp"
#include "support/open_session.hpp"

namespace planish {
namespace {

using testing::open_vault;

/// A point beside the mirror plane, raised.
EditTargets aside(const Session& session, double height) {
  constexpr int kAside = 5 * testing::kSide + 4;
  Eigen::Vector3d target = session.base().positions.col(kAside);
  target.z() += height;
  return {.handles = {{kAside, target}}, .pins = {}};
}

/// An edit as the command line makes it, and as the page does.
TEST(SessionSymmetry, AnEditIsWhatReplayMakesOfItsDesign) {
  Session session = open_vault();
  ASSERT_EQ(session.set_symmetry("auto", 1e-6), std::nullopt);
  ASSERT_NE(session.symmetry(), nullptr);
  const EditTargets targets = aside(session, 0.2);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 1.0), std::nullopt);
  EXPECT_LE(asymmetry(*session.symmetry(), session.base(), session.current()), 1e-9);

  Design design;
  design.source = SampleSource{"vault", testing::kSide};
  design.targets = targets;
  design.symmetry = session.symmetry()->elements;
  const auto replayed = replay(design);
  ASSERT_TRUE(std::holds_alternative<Replay>(replayed)) << std::get<std::string>(replayed);
  EXPECT_TRUE(testing::same_bits(std::get<Replay>(replayed).shape, session.current()));

  Session again = open_vault();
  EXPECT_NE(again.replay(design), std::nullopt) << "without the symmetry";
  ASSERT_EQ(again.set_symmetry("auto", 1e-6), std::nullopt);
  ASSERT_EQ(again.replay(design), std::nullopt);
  EXPECT_TRUE(testing::same_bits(again.current(), session.current()));
  design.symmetry = {{.axis = 2, .order = 3}};
  EXPECT_NE(again.replay(design), std::nullopt) << "with another one";
}

TEST(SessionSymmetry, ANearlySymmetricMeshIsEvenedOutAndAnotherBaseBeginsWithout) {
  Session session = open_vault();
  Mesh mesh = session.base();
  // Along the boundary's edge, so that panels stay flat: far below what files round away.
  const int corner = mesh.face(0)[0];
  const Eigen::Vector3d along = mesh.positions.col(mesh.face(0)[1]) - mesh.positions.col(corner);
  mesh.positions.col(corner) += 1e-6 * along;
  ASSERT_EQ(session.open_file(write_obj(mesh), "obj"), std::nullopt);
  const Positions opened = session.base().positions;
  ASSERT_EQ(session.set_symmetry("x", 1e-6), std::nullopt);
  EXPECT_FALSE(testing::same_bits(session.base().positions, opened));
  EXPECT_TRUE(testing::same_bits(session.before_planarising(), opened));
  EXPECT_LE(asymmetry(*session.symmetry(), session.base(), session.current()), 1e-10);
  ASSERT_EQ(session.open_sample("vault", 9), std::nullopt);
  EXPECT_EQ(session.symmetry(), nullptr);
}

TEST(SessionSymmetry, WhatCannotBeIsRefusedInASentence) {
  Session session = open_vault();
  const Positions before = session.base().positions;
  const auto first = [](const Refusal& refusal) { return refusal ? refusal->substr(0, 18) : ""; };
  EXPECT_EQ(first(session.set_symmetry("w", 1e-6)), "A symmetry must be");
  EXPECT_EQ(first(session.set_symmetry("axis:7", 1e-6)), "The mesh does not ");
  EXPECT_EQ(session.symmetry(), nullptr);
  ASSERT_EQ(session.set_symmetry("x", 1e-6), std::nullopt);
  EXPECT_TRUE(testing::same_bits(session.base().positions, before));
  HandleEditOptions options;
  options.engine = Engine::kAugmentedLagrangian;
  ASSERT_EQ(session.set_options(options), std::nullopt);
  const EditTargets targets = aside(session, 0.2);
  EXPECT_EQ(first(session.edit(EditMode::kSolve, targets, 1.0)), "The paper's engine");
  ASSERT_EQ(session.set_options({}), std::nullopt);
  ASSERT_EQ(session.edit(EditMode::kSolve, targets, 1.0), std::nullopt);
}

TEST(SessionSymmetry, VariationsHaveIt) {
  Session session = open_vault();
  ASSERT_EQ(session.set_symmetry("x", 1e-6), std::nullopt);
  ASSERT_EQ(session.edit(EditMode::kSolve, aside(session, 0.2), 1.0), std::nullopt);
  ASSERT_EQ(session.explore({.dimension = 2}), std::nullopt);
  const Positions edited = session.current();
  ASSERT_EQ(session.vary(Eigen::Vector2d(0.5, -0.7)), std::nullopt);
  EXPECT_FALSE(testing::same_bits(session.current(), edited));
  EXPECT_LE(asymmetry(*session.symmetry(), session.base(), session.current()), 1e-9);
  ASSERT_EQ(session.make_exact(), std::nullopt);
  EXPECT_LE(asymmetry(*session.symmetry(), session.base(), session.current()), 1e-9);
}

}  // namespace
}  // namespace planish
