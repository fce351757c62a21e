// SPDX-License-Identifier: MIT
/// What keeps its shape: no edit makes a panel concave, crossing, turned over or collapsed.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "planish/handle_edit.hpp"
#include "planish/panel_health.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

int spoilt_panels(const Mesh& mesh, const HandleEditResult& result) {
  const Positions after = apply(mesh, result);
  int count = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    count += panel_damage(mesh.positions, after, mesh.face(f)) != PanelDamage::kNone ? 1 : 0;
  }
  return count;
}

class EditShape : public ::testing::TestWithParam<const char*> {
 protected:
  EditShape() : mesh(testing::sample(GetParam(), 16)) {}

  /// The middle, a point beside it and one near a corner, up and sideways.
  [[nodiscard]] std::vector<EditTargets> edits() const {
    std::vector<EditTargets> targets;
    for (const int vertex : {testing::middle_vertex(mesh), mesh.vertex_count() / 3, 20}) {
      for (const double lift : {0.5, 1.0, 2.0}) {
        targets.push_back(testing::pull(mesh, vertex, {0.0, 0.0, lift}));
        targets.push_back(testing::pull(mesh, vertex, {lift, 0.3 * lift, 0.0}));
      }
    }
    return targets;
  }

  Mesh mesh;
};

TEST_P(EditShape, IsKeptByEveryEdit) {
  HandleEditSolver solver(mesh, {});
  for (const EditTargets& targets : edits()) {
    const HandleEditResult result = solver.solve(targets);
    EXPECT_EQ(spoilt_panels(mesh, result), 0);
    EXPECT_LE(result.report.planarity_after, testing::kPromise);
  }
}

TEST_P(EditShape, IsKeptByHardHandles) {
  HandleEditOptions options;
  options.hard_handles = true;
  HandleEditSolver solver(mesh, options);
  for (const EditTargets& targets : edits()) {
    const HandleEditResult result = solver.solve(targets);
    EXPECT_EQ(spoilt_panels(mesh, result), 0);
    if (result.report.status != SolveStatus::kInfeasibleHandles) {
      EXPECT_EQ(result.report.handle_error, 0.0);
    }
  }
}

TEST_P(EditShape, IsKeptByTheReferenceEngine) {
  HandleEditOptions options;
  options.engine = Engine::kAugmentedLagrangian;
  HandleEditSolver solver(mesh, options);
  const std::vector<EditTargets> all = edits();
  for (const std::size_t k : {2u, 4u}) EXPECT_EQ(spoilt_panels(mesh, solver.solve(all[k])), 0);
}

TEST_P(EditShape, IsKeptByEveryFrameOfADrag) {
  constexpr int kFrames = 40;
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  HandleEditSolver solver(mesh, {});
  for (int frame = 1; frame <= kFrames; ++frame) {
    const double share = 2.0 * frame / kFrames;
    const EditTargets targets =
        testing::pull(mesh, testing::middle_vertex(mesh), {0.3 * share, 0.0, share});
    EXPECT_EQ(spoilt_panels(mesh, solver.drag(targets, kBudget)), 0) << "frame " << frame;
  }
}

/// The bound is what keeps it: without it the same edits spoil panels on at least one sample.
TEST(EditShapeOff, SpoilsPanels) {
  HandleEditOptions options;
  options.keep_shape = false;
  const Mesh mesh = testing::sample("vault", 16);
  const HandleEditResult result = solve_handle_edit(
      mesh, testing::pull(mesh, testing::middle_vertex(mesh), {0.0, 0.0, 2.0}), options);
  EXPECT_GT(spoilt_panels(mesh, result), 0);
}

INSTANTIATE_TEST_SUITE_P(Samples, EditShape,
                         ::testing::Values("roof", "vault", "dome", "freeform", "hex", "trihex"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace planish
