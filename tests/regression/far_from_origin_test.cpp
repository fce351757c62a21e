// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "planish/metrics.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// At an offset of 1e7 the coordinates' own rounding is above 1e-6 mm/m: every edit was refused as
/// "infeasible" for it.
TEST(FarFromOrigin, AnEditIsAsFlatAsTheCoordinatesAllow) {
  Mesh mesh = testing::sample("vault", 8);
  mesh.positions.array() += 1e7;
  EXPECT_GT(attainable_tolerance(mesh, 1e-6), 1e-6);
  for (const double height : {0.5, 3.0}) {
    const EditTargets targets = testing::pull(mesh, 27, {0.0, 0.0, height});
    const HandleEditResult result = solve_handle_edit(mesh, targets);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
    EXPECT_LT(result.report.handle_error, 0.1 * height);
    EXPECT_LT(result.report.planarity_after, 1e-5);
  }
}

TEST(FarFromOrigin, NothingChangesNearIt) {
  for (const char* name : {"vault", "dome", "freeform", "hex", "trihex"}) {
    EXPECT_EQ(attainable_tolerance(testing::sample(name, 32), 1e-6), 1e-6) << name;
  }
}

}  // namespace
}  // namespace planish
