// SPDX-License-Identifier: MIT
/// Variations of edits that keep more than planarity: tangent to it, and exact after (8). Measured
/// without the product's code.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "planish/handle_edit.hpp"
#include "planish/metrics.hpp"
#include "planish/projection.hpp"
#include "planish/subspace.hpp"
#include "support/circles.hpp"
#include "support/cones.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kTolerance = 1e-9;  ///< degrees

class KeptVariations : public ::testing::TestWithParam<const char*> {
 protected:
  KeptVariations() : base(testing::sample("dome", 17)), handle(testing::middle_vertex(base)) {
    options.constraints = {{GetParam(), kTolerance}};
    const EditTargets targets = testing::pull(base, handle, {0.0, 0.0, 0.3});
    edited = apply(base, solve_handle_edit(base, targets, options));
  }

  [[nodiscard]] Subspace family(const KeptKinds& kept) const {
    return compute_subspace(base, edited, {handle}, {.dimension = 3}, {}, kept);
  }

  /// The edit with slider `k` at `value`.
  [[nodiscard]] Positions slid(const Subspace& subspace, int k, double value) const {
    Positions rows;
    evaluate(subspace, value * Eigen::VectorXd::Unit(subspace.dimension(), k), rows);
    Positions positions = edited;
    positions(Eigen::all, subspace.support) = rows;
    return positions;
  }

  [[nodiscard]] double defect(const Positions& positions) const {
    return std::string(GetParam()) == "circular" ? testing::inscribed_defect(base, positions)
                                                 : testing::worst_cone_defect(base, positions);
  }

  /// How the defect falls where a slider goes half as far: 1/4 along a tangent, 1/2 across.
  [[nodiscard]] double fall(const Subspace& subspace, int k) const {
    constexpr double kFar = 0.02;
    return defect(slid(subspace, k, 0.5 * kFar)) / defect(slid(subspace, k, kFar));
  }

  Mesh base;
  int handle;
  HandleEditOptions options;
  Positions edited;
};

TEST_P(KeptVariations, AreTangentToWhatTheEditKeeps) {
  ASSERT_LE(defect(edited), kTolerance);
  const Subspace kept = family(kept_kinds(options.tolerance, options.constraints));
  ASSERT_EQ(kept.dimension(), 3) << status_name(kept.report.status);
  EXPECT_LT(kept.report.tangency_error, 1e-8);
  EXPECT_LT(kept.report.orthonormality_error, 1e-8);
  for (int k = 0; k < 3; ++k) EXPECT_LT(fall(kept, k), 0.3) << "vector " << k;
  const Subspace flat = family(KeptKinds());
  ASSERT_EQ(flat.dimension(), 3);
  double worst = 0.0;
  for (int k = 0; k < 3; ++k) worst = std::max(worst, fall(flat, k));
  EXPECT_GT(worst, 0.4) << "flat panels alone would do";
}

TEST_P(KeptVariations, MadeExactKeepItAndLeaveTheRest) {
  const KeptKinds kinds = kept_kinds(options.tolerance, options.constraints);
  const Subspace subspace = family(kinds);
  ASSERT_EQ(subspace.dimension(), 3);
  for (int k = 0; k < 3; ++k) {
    Mesh shown = base;
    shown.positions = slid(subspace, k, 0.3);
    EXPECT_GT(defect(shown.positions), kTolerance);
    ProjectionOptions exact;
    exact.constraints = options.constraints;
    const ProjectionResult result = project_to_planar(shown, base.positions, exact);
    ASSERT_TRUE(result.report.usable()) << status_name(result.report.status);
    Positions after = shown.positions;
    after(Eigen::all, result.moved) = result.moved_positions;
    EXPECT_LE(defect(after), kTolerance) << "vector " << k;
    EXPECT_LE(planarity_summary(base, after).max_excess, testing::kPromise);
    EXPECT_NE(after, edited) << "the slider is lost";
    EXPECT_LT((after - shown.positions).norm(), 0.5 * (shown.positions - edited).norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, KeptVariations, ::testing::Values("circular", "conical"));

}  // namespace
}  // namespace planish
