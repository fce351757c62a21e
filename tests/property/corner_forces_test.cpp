// SPDX-License-Identifier: MIT
/// What holds panels flat: forces at their corners that turn and move no panel as a whole, and
/// moments across lines that are the same from either side.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "planish/constraints/stated_limit.hpp"
#include "planish/edit/handle_edit.hpp"
#include "splitting/line_moment.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kOfLargest = 1e-6;

/// A handle that stops short beside a boundary that stays.
class HeldEdits : public ::testing::TestWithParam<const char*> {
 protected:
  HeldEdits() {
    HandleEditOptions options;
    options.softness = 3.0;
    options.reach = 3;
    options.keep_boundary = true;
    options.bounds.push_back(*parse_stated_limit("fold=+12"));
    HandleEditSolver solver(mesh_, options);
    const int vertex = testing::middle_vertex(mesh_);
    const double edge = mean_edge_length(mesh_);
    const auto result = solver.solve(testing::pull(mesh_, vertex, {0.0, 0.0, edge}));
    shape_ = apply(mesh_, result);
    forces_ = solver.corner_forces();
    for (const CornerForce& one : forces_) largest_ = std::max(largest_, one.force.norm());
  }

  const Mesh mesh_ = testing::sample(GetParam(), 12);
  Positions shape_;
  std::vector<CornerForce> forces_;
  double largest_ = 0.0;
};

TEST_P(HeldEdits, NeitherMoveNorTurnAPanel) {
  ASSERT_GT(largest_, 0.0);
  std::vector<Eigen::Vector3d> sums(static_cast<std::size_t>(mesh_.face_count()),
                                    Eigen::Vector3d::Zero());
  auto turns = sums;
  for (const CornerForce& one : forces_) {
    const auto corners = mesh_.face(one.panel);
    ASSERT_NE(std::find(corners.begin(), corners.end(), one.vertex), corners.end());
    const Eigen::Vector3d arm = shape_.col(one.vertex) - shape_.col(corners[0]);
    sums[static_cast<std::size_t>(one.panel)] += one.force;
    turns[static_cast<std::size_t>(one.panel)] += arm.cross(one.force);
  }
  const double edge = mean_edge_length(mesh_);
  for (std::size_t f = 0; f < sums.size(); ++f) {
    EXPECT_LE(sums[f].norm(), kOfLargest * largest_) << f;
    EXPECT_LE(turns[f].norm(), kOfLargest * largest_ * edge) << f;
  }
}

TEST_P(HeldEdits, BendAPanelAsMuchFromEitherSideOfALine) {
  double most = 0.0;
  for (int f = 0; f < mesh_.face_count(); ++f) {
    const auto corners = mesh_.face(f);
    for (std::size_t c = 2; c + 1 < corners.size(); ++c) {
      const double there = moment_across(mesh_, shape_, forces_, {f, {corners[0]}, {corners[c]}});
      const double back = moment_across(mesh_, shape_, forces_, {f, {corners[c]}, {corners[0]}});
      EXPECT_NEAR(there, back, kOfLargest * largest_ * mean_edge_length(mesh_)) << f;
      most = std::max(most, there);
    }
  }
  EXPECT_GT(most, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Meshes, HeldEdits, ::testing::Values("vault", "dome", "hex"));

}  // namespace
}  // namespace planish
