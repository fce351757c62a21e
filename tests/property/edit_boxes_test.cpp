// SPDX-License-Identifier: MIT
/// What boxes hold, by their own numbers and as models of six panels: no panel of an edit or of a
/// drag enters one, measured without the rows.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <string>

#include "planish/edit/handle_edit.hpp"
#include "support/edit_invariants.hpp"
#include "support/mesh_builders.hpp"
#include "support/obstacles.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::boxes_near;
using testing::BoxInTheWay;
using testing::worst_entry;

constexpr double kOutside = 1e-9;  ///< mean edges: what was promised

class EditBoxes : public testing::OnObstructedMesh {
 protected:
  /// Every night 100 where they are cheap; docs/decisions/0040-keep-outs.md has 100 of each.
  /// WebAssembly, which runs the same code, is asked for a few.
  [[nodiscard]] static int edits() {
#ifdef __EMSCRIPTEN__
    return 10;
#else
    return testing::by_night(std::string(GetParam()) == "pq_gitter" ? 100 : 20, 10);
#endif
  }
  /// Of how many it is asked whether the box is in the way at all.
  static constexpr int kAlsoWithout = 10;
  /// How many of the boxes are also models of six panels.
  [[nodiscard]] static int models() {
#ifdef __EMSCRIPTEN__
    return 10;
#else
    return testing::by_night(20, 5);
#endif
  }
  [[nodiscard]] HandleEditOptions options_for(const BoxInTheWay& one) const {
    HandleEditOptions options;
    options.keep_outs = {*parse_keep_out(one.box.text())};
    options.clearance = 0.05 * mean_edge_length(mesh);
    return options;
  }
};

TEST_P(EditBoxes, NoPanelEntersOne) {
  int certified = 0, entered_without = 0, made = 0, moved = 0;
  for (const BoxInTheWay& one : boxes_near(mesh, 61, edits())) {
    SCOPED_TRACE("vertex " + std::to_string(one.vertex) + " " + one.box.text());
    const EditTargets targets = testing::pull(mesh, one.vertex, one.move);
    const HandleEditOptions options = options_for(one);
    const HandleEditResult result = solve_handle_edit(mesh, targets, options);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    EXPECT_LE(worst_entry(mesh, result, one.box, options.clearance), kOutside);
    certified += result.report.status == SolveStatus::kConverged ? 1 : 0;
    moved += result.report.moved_vertices > 0 ? 1 : 0;
    if (++made > kAlsoWithout) continue;
    const HandleEditResult free = solve_handle_edit(mesh, targets);
    entered_without += worst_entry(mesh, free, one.box, options.clearance) > 1e-6 ? 1 : 0;
  }
  std::printf("%s: %d certified, %d moved of %d; %d of %d enter without\n", GetParam(), certified,
              moved, edits(), entered_without, kAlsoWithout);
  EXPECT_GE(entered_without, kAlsoWithout / 2);
  EXPECT_GE(moved, 9 * edits() / 10);
  EXPECT_GE(certified, 9 * edits() / 10);
}

/// Edits first go through models, and are then made again.
TEST_P(EditBoxes, NoPanelEntersOneThatIsAModel) {
  int certified = 0, moved = 0;
  for (const BoxInTheWay& one : boxes_near(mesh, 61, models())) {
    SCOPED_TRACE("vertex " + std::to_string(one.vertex) + " " + one.box.text());
    const EditTargets targets = testing::pull(mesh, one.vertex, one.move);
    HandleEditOptions options = options_for(one);
    options.keep_outs = {*parse_keep_out(one.box.model_text())};
    const HandleEditResult result = solve_handle_edit(mesh, targets, options);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    EXPECT_LE(worst_entry(mesh, result, one.box, options.clearance), kOutside);
    certified += result.report.status == SolveStatus::kConverged ? 1 : 0;
    moved += result.report.moved_vertices > 0 ? 1 : 0;
  }
  std::printf("%s: %d certified, %d moved of %d\n", GetParam(), certified, moved, models());
  EXPECT_GE(10 * moved, 9 * models());
  EXPECT_GE(10 * certified, 9 * models());
}

/// Boxes around the handle itself: panels that are inside go no deeper, and the others stay out.
TEST_P(EditBoxes, NoPanelThatIsInsideGoesDeeper) {
  const int boxes = testing::by_night(10, 4);
  int moved = 0;
  for (BoxInTheWay one : boxes_near(mesh, 71, boxes)) {
    SCOPED_TRACE("vertex " + std::to_string(one.vertex));
    const Eigen::Vector3d half = 0.5 * (one.box.high - one.box.low);
    const Eigen::Vector3d middle = mesh.positions.col(one.vertex) + 0.3 * one.move;
    one.box = {middle - half, middle + half};
    const EditTargets targets = testing::pull(mesh, one.vertex, one.move);
    const HandleEditOptions options = options_for(one);
    const HandleEditResult result = solve_handle_edit(mesh, targets, options);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    EXPECT_LE(worst_entry(mesh, result, one.box, options.clearance), kOutside);
    moved += result.report.moved_vertices > 0 ? 1 : 0;
  }
  EXPECT_GE(2 * moved, boxes);
}

TEST_P(EditBoxes, NoFrameOfADragEntersOne) {
  constexpr int kFrames = 8;
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  for (const BoxInTheWay& one : boxes_near(mesh, 67, testing::by_night(6, 2))) {
    SCOPED_TRACE("vertex " + std::to_string(one.vertex) + " " + one.box.text());
    const HandleEditOptions options = options_for(one);
    HandleEditSolver solver(mesh, options);
    for (int frame = 1; frame <= kFrames; ++frame) {  // fast: through the box and out again
      const auto targets = testing::pull(mesh, one.vertex, (3.0 * frame / kFrames) * one.move);
      const HandleEditResult result = solver.drag(targets, kBudget);
      EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
      EXPECT_LE(worst_entry(mesh, result, one.box, options.clearance), kOutside) << frame;
    }
  }
}

/// A model that is not in the way changes no bit.
TEST_P(EditBoxes, AModelThatNothingMeetsChangesNothing) {
  const BoxInTheWay one = boxes_near(mesh, 61, 1).front();
  const Eigen::Vector3d away = 100.0 * mean_edge_length(mesh) * Eigen::Vector3d::Ones();
  const testing::Box far{one.box.low + away, one.box.high + away};
  const EditTargets targets = testing::pull(mesh, one.vertex, one.move);
  HandleEditOptions options = options_for(one);
  options.keep_outs = {*parse_keep_out(far.model_text())};
  const HandleEditResult free = solve_handle_edit(mesh, targets);
  const HandleEditResult result = solve_handle_edit(mesh, targets, options);
  EXPECT_TRUE(testing::same_bits(apply(mesh, result), apply(mesh, free)));
  EXPECT_EQ(result.report.status, free.report.status);
}

TEST_P(EditBoxes, NoFrameOfADragEntersOneThatIsAModel) {
  constexpr int kFrames = 8;
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  for (const BoxInTheWay& one : boxes_near(mesh, 67, testing::by_night(6, 2))) {
    SCOPED_TRACE("vertex " + std::to_string(one.vertex) + " " + one.box.text());
    HandleEditOptions options = options_for(one);
    options.keep_outs = {*parse_keep_out(one.box.model_text())};
    HandleEditSolver solver(mesh, options);
    for (int frame = 1; frame <= kFrames; ++frame) {
      const auto targets = testing::pull(mesh, one.vertex, (3.0 * frame / kFrames) * one.move);
      const HandleEditResult result = solver.drag(targets, kBudget);
      EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
      EXPECT_LE(worst_entry(mesh, result, one.box, options.clearance), kOutside) << frame;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, EditBoxes,
                         ::testing::Values("vault", "pq_gitter", "mixed345_airport"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace planish
