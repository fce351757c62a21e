// SPDX-License-Identifier: MIT
/// The kind of docs/extending.md, registered by one line in the build for sanitizers: an edit keeps
/// it with either engine, and what it promises is measured without its code.
#ifdef PLANISH_EXAMPLES

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kTolerance = 1e-6;  ///< mm/m

/// Largest difference between a panel's diagonals over their mean, mm/m.
double uneven_diagonals(const Mesh& mesh, const Positions& p) {
  double worst = 0.0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const double first = (p.col(face[0]) - p.col(face[2])).norm();
    const double second = (p.col(face[1]) - p.col(face[3])).norm();
    worst = std::max(worst, 2000.0 * std::abs(first - second) / (first + second));
  }
  return worst;
}

class ExampleKind : public ::testing::TestWithParam<Engine> {
 protected:
  HandleEditResult edit(bool kept) {
    HandleEditOptions options;
    options.engine = GetParam();
    if (kept) options.constraints = {{"equal-diagonals", kTolerance}};
    return solve_handle_edit(
        mesh_, testing::pull(mesh_, testing::middle_vertex(mesh_), {0.0, 0.0, 0.3}), options);
  }

  const Mesh mesh_ = testing::sample("dome", 12);
};

TEST_P(ExampleKind, IsKeptByAnEdit) {
  ASSERT_LT(uneven_diagonals(mesh_, mesh_.positions), kTolerance);
  const HandleEditResult result = edit(true);
  ASSERT_TRUE(result.report.usable());
  EXPECT_FALSE(result.moved.empty());
  const Positions after = apply(mesh_, result);
  EXPECT_LE(uneven_diagonals(mesh_, after), kTolerance);
  EXPECT_LE(planarity_summary(mesh_, after).max, testing::kPromise);
  ASSERT_EQ(result.report.violations.size(), 2U);
  EXPECT_EQ(result.report.violations[1].kind, "equal-diagonals");
  EXPECT_GT(uneven_diagonals(mesh_, apply(mesh_, edit(false))), 1.0) << "not by chance";
}

INSTANTIATE_TEST_SUITE_P(Engines, ExampleKind,
                         ::testing::Values(Engine::kNewton, Engine::kAugmentedLagrangian));

}  // namespace
}  // namespace planish

#endif
