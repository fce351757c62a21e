// SPDX-License-Identifier: MIT
/// The checks of the property tests notice what they are there for.
#include "support/edit_invariants.hpp"

#include <gtest/gtest.h>

#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::is_valid_edit;

struct Edited {
  Mesh mesh = testing::sample("vault", 10);
  EditTargets targets = testing::pull(mesh, 44, {0.0, 0.0, 0.5});
  HandleEditResult result = solve_handle_edit(mesh, targets);
};

TEST(EditInvariants, AcceptAnEdit) {
  const Edited edited;
  EXPECT_GT(edited.result.moved.size(), 1u);
  EXPECT_TRUE(is_valid_edit(edited.mesh, edited.targets, edited.result));
}

TEST(EditInvariants, NoticeABentPanel) {
  Edited edited;
  edited.result.moved_positions(2, 0) += 1e-7;
  EXPECT_FALSE(is_valid_edit(edited.mesh, edited.targets, edited.result));
}

TEST(EditInvariants, NoticeAVertexThatDidNotMove) {
  Edited edited;
  edited.result.moved_positions.col(0) = edited.mesh.positions.col(edited.result.moved[0]);
  EXPECT_FALSE(is_valid_edit(edited.mesh, edited.targets, edited.result));
}

TEST(EditInvariants, NoticeAPinThatMoved) {
  Edited edited;
  edited.targets.pins = {edited.result.moved[0]};
  EXPECT_FALSE(is_valid_edit(edited.mesh, edited.targets, edited.result));
}

TEST(EditInvariants, NoticeAWrongReport) {
  Edited edited;
  edited.result.report.planarity_after += 1e-5;
  EXPECT_FALSE(is_valid_edit(edited.mesh, edited.targets, edited.result));
  edited.result.report = solve_handle_edit(edited.mesh, edited.targets).report;
  edited.result.report.handle_error += 1e-6;
  EXPECT_FALSE(is_valid_edit(edited.mesh, edited.targets, edited.result));
  edited.result.report = solve_handle_edit(edited.mesh, edited.targets).report;
  ++edited.result.report.moved_vertices;
  EXPECT_FALSE(is_valid_edit(edited.mesh, edited.targets, edited.result));
}

TEST(EditInvariants, NoticeAnUnsoundBasis) {
  const Edited edited;
  const Positions positions = apply(edited.mesh, edited.result);
  Subspace subspace = compute_subspace(edited.mesh, positions, {44}, {.dimension = 2});
  EXPECT_TRUE(testing::is_valid_subspace(positions, subspace));
  subspace.basis.col(1) *= 1.0 + 1e-7;
  EXPECT_FALSE(testing::is_valid_subspace(positions, subspace));
}

}  // namespace
}  // namespace planish
