// SPDX-License-Identifier: MIT
/// What the closeness and fairness terms do to an edit: Figs 2, 3, 8 and 9 of the paper.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/projection/planarising.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kLift = 0.5;
constexpr double kNoticeable = 0.01;  ///< of the handle's displacement

std::size_t noticeable(const Mesh& mesh, const HandleEditResult& result, double lift) {
  return testing::moved_beyond(mesh, result, kNoticeable * lift).size();
}

/// Fig. 3, left: ω_f = 0 recovers [Hof10].
TEST(EditLocality, NoSmoothnessMovesOnlyTheCloseNeighbourhood) {
  const Mesh mesh = testing::sample("vault", 17);
  const int handle = 8 * 17 + 8;
  const HandleEditResult result = solve_handle_edit(
      mesh, testing::pull(mesh, handle, {0, 0, kLift}), {.smoothness = 0.0, .keep_shape = false});
  EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
  const std::vector<int> moved = testing::moved_beyond(mesh, result, kNoticeable * kLift);
  const std::vector<int> near = testing::ring_neighbourhood(mesh, handle, 2);
  EXPECT_LE(moved.size(), 16u);
  EXPECT_TRUE(std::includes(near.begin(), near.end(), moved.begin(), moved.end()));
  EXPECT_LE(planarity_summary(mesh, apply(mesh, result)).max, 1e-6);
}

/// Hard handles leave some thirty points of their reach to be corrected that have nothing to do.
TEST(EditLocality, NoPointMovesByRoundingAlone) {
  constexpr double kRounding = 1e-11;  // mean edges
  for (const double away : {0.0, 1e4}) {
    for (const char* name : {"roof", "vault", "dome", "freeform", "hex", "trihex"}) {
      Mesh mesh = testing::sample(name, 13);
      mesh.positions.array() += away;
      const EditTargets targets = testing::pull(mesh, testing::middle_vertex(mesh), {0, 0, 0.3});
      const double tolerance = away > 0.0 ? 1e-4 : 1e-6;  // mm/m
      HandleEditOptions options;
      options.hard_handles = true;
      options.tolerance = tolerance;
      options.reach = 6;
      const HandleEditResult result = solve_handle_edit(mesh, targets, options);
      ASSERT_TRUE(result.report.usable()) << name;
      const double least = kRounding * mean_edge_length(mesh);
      for (std::size_t k = 0; k < result.moved.size(); ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        const Eigen::Vector3d move =
            result.moved_positions.col(column) - mesh.positions.col(result.moved[k]);
        EXPECT_GT(move.norm(), least) << name << ' ' << away << ": vertex " << result.moved[k];
      }
      EXPECT_LE(planarity_summary(mesh, apply(mesh, result)).max_excess, tolerance) << name;
    }
  }
}

/// A panel that is bent alone is mended where it is: far away no point changes its bits.
TEST(EditLocality, NoPointOfAPlanarisedMeshMovesByRoundingAlone) {
  Mesh mesh = testing::sample("vault", 25);
  const int bent = testing::middle_vertex(mesh);
  mesh.positions(2, bent) += 0.01;
  const ProjectionResult result = planarise(mesh, kNearestFlat);
  ASSERT_TRUE(result.report.usable());
  ASSERT_FALSE(result.moved.empty());
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const Eigen::Vector3d move =
        result.moved_positions.col(column) - mesh.positions.col(result.moved[k]);
    EXPECT_GT(move.norm(), 1e-11 * mean_edge_length(mesh)) << "vertex " << result.moved[k];
  }
}

/// Fig. 3: the higher ω_f, the wider and smoother.
TEST(EditLocality, GrowsWithSmoothness) {
  const Mesh mesh = testing::sample("dome", 24);
  const EditTargets targets = testing::pull(mesh, testing::middle_vertex(mesh), {0, 0, kLift});
  const auto count = [&](double smoothness) {
    return noticeable(mesh, solve_handle_edit(mesh, targets, {.smoothness = smoothness}), kLift);
  };
  const std::size_t none = count(0.0), some = count(1.0), much = count(30.0);
  EXPECT_LT(none, some);
  EXPECT_LT(some, much);
}

TEST(EditLocality, ShrinksWithItsWeight) {
  const Mesh mesh = testing::sample("dome", 24);
  const EditTargets targets = testing::pull(mesh, testing::middle_vertex(mesh), {0, 0, kLift});
  const auto count = [&](double locality) {
    return solve_handle_edit(mesh, targets, {.locality = locality}).moved.size();
  };
  EXPECT_GT(count(0.1), count(1.0));
  EXPECT_GE(count(1.0), count(5.0));
}

/// Fig. 2: with equal fairness energy, ℓ2,1 moves at most 0.7 times as many vertices as ℓ2.
TEST(EditLocality, L21IsMoreLocalThanL2AtEqualFairness) {
  for (const char* name : {"vault", "dome"}) {
    const Mesh mesh = testing::sample(name, 24);
    const EditTargets targets = testing::pull(mesh, testing::middle_vertex(mesh), {0, 0, kLift});
    // Hard handles: a strong ℓ2 term would otherwise hold the handle back as well.
    const HandleEditResult sparse = solve_handle_edit(mesh, targets, {.hard_handles = true});
    const double wanted = sparse.report.objective.fairness;
    double low = 1e-4, high = 1e3;
    HandleEditResult square;  // at least as rough as `sparse`, so at least as local as at equality
    for (int k = 0; k < 24; ++k) {
      const double middle = std::sqrt(low * high);
      const HandleEditResult tried = solve_handle_edit(
          mesh, targets, {.locality = middle, .sparsity = Sparsity::kL2, .hard_handles = true});
      const bool rougher = tried.report.objective.fairness >= wanted;
      (rougher ? high : low) = middle;
      if (rougher) square = tried;
    }
    ASSERT_GE(square.report.objective.fairness, wanted) << name;
    RecordProperty(std::string(name) + "_l21", static_cast<int>(noticeable(mesh, sparse, kLift)));
    RecordProperty(std::string(name) + "_l2", static_cast<int>(noticeable(mesh, square, kLift)));
    EXPECT_LE(static_cast<double>(noticeable(mesh, sparse, kLift)),
              0.7 * static_cast<double>(noticeable(mesh, square, kLift)))
        << name;
  }
}

/// Figs 8 and 9: fewer degrees of freedom per vertex need a larger region.
TEST(EditLocality, HexagonsNeedALargerRegionThanTriHex) {
  const auto area = [](const char* name) {
    const Mesh mesh = testing::sample(name, 24);
    const HandleEditResult result =
        solve_handle_edit(mesh, testing::pull(mesh, testing::middle_vertex(mesh), {0, 0, kLift}));
    EXPECT_TRUE(result.report.usable()) << name;
    return testing::moved_beyond(mesh, result, kNoticeable * kLift).size();
  };
  EXPECT_GT(area("hex"), area("trihex"));
}

}  // namespace
}  // namespace planish
