// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "planish/io/mesh_format.hpp"
#include "session.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// −0 + 0 is 0: points that a variation leaves alone lost the sign of their zero, unlisted.
TEST(NegativeZero, SurvivesAVariation) {
  Mesh mesh = testing::sample("vault", 9);
  for (Eigen::Index v = 0; v < mesh.positions.cols(); ++v) {
    for (double& x : mesh.positions.col(v)) x = x == 0.0 ? -0.0 : x;
  }
  Session session;
  ASSERT_EQ(session.open_file(write_mesh(mesh, MeshFormat::kPly), "ply"), std::nullopt);
  ASSERT_EQ(session.edit(EditMode::kSolve, testing::pull(mesh, 40, {0, 0, 0.5}), 1.0),
            std::nullopt);
  const Positions edited = session.current();
  ASSERT_EQ(session.explore({.dimension = 1, .reach = 12}), std::nullopt);
  ASSERT_EQ(session.vary(Eigen::VectorXd::Zero(1)), std::nullopt);
  EXPECT_TRUE(testing::same_bits(session.current(), edited));
}

}  // namespace
}  // namespace planish
