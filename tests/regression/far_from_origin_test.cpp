// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "planish/measures/metrics.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// At an offset of 1e7 the coordinates' own rounding is above 1e-6 mm/m: every edit was refused as
/// "infeasible" for it.
TEST(FarFromOrigin, AnEditIsAsFlatAsTheCoordinatesAllow) {
  Mesh mesh = testing::sample("vault", 8);
  mesh.positions.array() += 1e7;
  EXPECT_EQ(planarity_summary(mesh).max_excess, 0.0);
  for (const double height : {0.5, 3.0}) {
    const EditTargets targets = testing::pull(mesh, 27, {0.0, 0.0, height});
    const HandleEditResult result = solve_handle_edit(mesh, targets);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
    EXPECT_LT(result.report.handle_error, 0.1 * height);
    EXPECT_LT(result.report.planarity_after, 1e-5);
  }
}

/// `mesh` and, in the same file, a flat panel of 1e-6.
Mesh with_small_panel(Mesh mesh) {
  const int n = mesh.vertex_count();
  mesh.positions.conservativeResize(3, n + 4);
  mesh.positions.rightCols(4) << 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0;
  mesh.positions.rightCols(4) *= 1e-6;
  for (int k = 0; k < 4; ++k) mesh.face_vertices.push_back(n + k);
  mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
  return mesh;
}

/// The tolerance of the whole mesh was once that of its smallest panel: then 100 times the promise
/// passed for flat everywhere.
TEST(FarFromOrigin, ASmallPanelDoesNotExcuseTheOthers) {
  Mesh mesh = with_small_panel(testing::sample("vault", 8));
  mesh.positions.col(27).z() += 1e-7;
  const double before = testing::worst_svd_mm_per_m(mesh, mesh.positions);
  ASSERT_GT(before, 1e-5);
  ASSERT_LT(before, 1e-3);
  EXPECT_GT(planarity_summary(mesh).max_excess, 1e-6);
  const ProjectionResult flat = project_to_planar(mesh);
  EXPECT_TRUE(flat.report.usable());
  EXPECT_LE(testing::worst_svd_mm_per_m(mesh, testing::apply(mesh, flat)), 1e-6);
}

/// Rounding excuses at most 1e-3 mm/m, however far away.
TEST(FarFromOrigin, WhatCannotBeHeldIsNotCalledFlat) {
  Mesh mesh = testing::sample("vault", 8);
  mesh.positions.array() += 1e13;
  const ProjectionResult flat = project_to_planar(mesh);
  EXPECT_TRUE(testing::is_valid_projection(mesh, {}, flat));
  EXPECT_EQ(flat.report.status, SolveStatus::kToleranceNotMet);
  EXPECT_FALSE(flat.failing_faces.empty());
}

TEST(FarFromOrigin, NothingIsExcusedNearIt) {
  for (const char* name : {"vault", "dome", "freeform", "hex", "trihex"}) {
    Mesh mesh = testing::sample(name, 32);
    mesh.positions.row(2).array() +=
        Eigen::Array<double, 1, Eigen::Dynamic>::LinSpaced(mesh.positions.cols(), 0.0, 1e-3).sin() *
        1e-6;
    for (int f = 0; f < mesh.face_count(); ++f) {
      const FacePlanarity flatness = face_planarity(mesh.positions, mesh.face(f));
      if (flatness.mm_per_m <= 1e-6) continue;
      EXPECT_EQ(flatness.excess, flatness.mm_per_m) << name;
    }
  }
}

/// An edit next to a panel that was never flat is no exact design.
TEST(FarFromOrigin, AnEditOfABaseThatIsNotFlatIsNotCalledConverged) {
  Mesh mesh = testing::sample("vault", 32);
  mesh.positions.col(0).z() += 0.1;
  const EditTargets targets = testing::pull(mesh, 32 * 20 + 20, {0.0, 0.0, 0.3});
  const HandleEditResult result = solve_handle_edit(mesh, targets);
  EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
  EXPECT_EQ(result.report.status, SolveStatus::kToleranceNotMet);
}

}  // namespace
}  // namespace planish
