// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "planish/projection/planarising.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// A quad pressed into a point had a boundless equation, and nothing on the mesh could move.
TEST(CollapsedPanel, DoesNotHoldTheRestOfTheMesh) {
  Mesh mesh =
      testing::quad_grid(5, 5, [](double i, double j) { return 0.1 * i * i + 0.05 * i * j; });
  for (const int v : {19, 23, 24}) mesh.positions.col(v) = mesh.positions.col(18);
  const ProjectionResult flat = planarise(mesh, kNearestFlat);
  EXPECT_TRUE(testing::is_valid_projection(mesh, {}, flat));
  EXPECT_TRUE(flat.report.usable()) << status_name(flat.report.status);
  mesh.positions = testing::apply(mesh, flat);
  const EditTargets targets = testing::pull(mesh, 12, {0.0, 0.0, 0.5});
  const HandleEditResult result = solve_handle_edit(mesh, targets);
  EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
  EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
  EXPECT_LT(result.report.handle_error, 0.1);
}

}  // namespace
}  // namespace planish
