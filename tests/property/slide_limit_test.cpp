// SPDX-License-Identifier: MIT
/// The limit on slides beyond single edits: random ones, variations made exact, edits of all
/// images.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

#include "planish/edit/handle_edit.hpp"
#include "planish/edit/symmetric_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/motion.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/symmetry/symmetry.hpp"
#include "planish/variations/exact_variation.hpp"
#include "planish/variations/subspace.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"
#include "support/slides.hpp"

namespace planish {
namespace {

constexpr double kRounding = 1e-6;  ///< of the limit

/// 0 … 1, evenly enough.
double share_of(double number) { return std::fmod(std::abs(number), 1.0); }

class SlideLimitOn : public ::testing::TestWithParam<const char*> {
 protected:
  SlideLimitOn() : mesh(testing::sample(GetParam(), 12)), edge(mean_edge_length(mesh)) {}

  /// The page's way of editing, or the weights' own; the boundary kept or free.
  [[nodiscard]] HandleEditOptions options_of(int number, double most) const {
    HandleEditOptions options;
    if (number % 2 == 0) {
      options.reach = 5;
      options.softness = 5.0;
    }
    options.keep_boundary = number % 3 == 0;
    options.bounds = {{.name = "slide", .most = most}};
    return options;
  }

  Mesh mesh;
  double edge;
};

/// Pulls in random directions at random points, with limits of a twentieth to a half of an edge.
TEST_P(SlideLimitOn, HoldsInRandomEdits) {
  const int edits = testing::by_night(12, 3);
  int held = 0, certified = 0;
  for (const unsigned seed : testing::seeds()) {
    const Eigen::Matrix3Xd moves = testing::random_points(seed, edits);
    const Eigen::Matrix3Xd picks = testing::random_points(seed + 1, edits);
    for (int k = 0; k < edits; ++k) {
      const double most = (0.05 + 0.45 * share_of(picks(0, k))) * edge;
      const int vertex = static_cast<int>(share_of(picks(1, k)) * mesh.vertex_count());
      SCOPED_TRACE(std::to_string(k) + ": vertex " + std::to_string(vertex));
      const EditTargets asked = testing::pull(mesh, vertex, 0.8 * edge * moves.col(k));
      const HandleEditResult result = solve_handle_edit(mesh, asked, options_of(k, most));
      const Positions after = apply(mesh, result);
      const double worst = testing::largest_slide(mesh, after);
      EXPECT_LE(worst, most * (1.0 + kRounding));
      EXPECT_LE(result.report.planarity_after, testing::kPromise);
      const MotionRange range = range_of(motions(mesh, build_adjacency(mesh), result.moved, after));
      EXPECT_NEAR(range.slide, worst, 1e-12 * edge) << "the report's measure is another";
      if (result.report.status != SolveStatus::kConverged) continue;
      ++certified;
      if (result.report.bounds[0].binding.empty()) continue;
      ++held;
      EXPECT_GE(worst, most * (1.0 - 1e-4)) << "something is given away";
    }
  }
  EXPECT_GT(certified, edits / 2);
  EXPECT_GT(held, 0);
}

/// One that is dragged sideways stops at the limit, also where it was to be met exactly.
TEST_P(SlideLimitOn, CountsHandles) {
  const int vertex = testing::middle_vertex(mesh);
  const EditTargets aside = testing::pull(mesh, vertex, {0.6 * edge, 0.0, 0.0});
  const HandleEditOptions options = options_of(2, 0.2 * edge);
  const Positions after = apply(mesh, solve_handle_edit(mesh, aside, options));
  EXPECT_LE(testing::slides(mesh, after)[static_cast<std::size_t>(vertex)],
            0.2 * edge * (1.0 + kRounding));
  HandleEditOptions hard = options;
  hard.hard_handles = true;
  const HandleEditResult result = solve_handle_edit(mesh, aside, hard);
  EXPECT_LE(testing::largest_slide(mesh, apply(mesh, result)), 0.2 * edge * (1.0 + kRounding));
  EXPECT_EQ(result.report.status, SolveStatus::kInfeasibleHandles);
}

TEST_P(SlideLimitOn, HoldsInVariationsThatAreMadeExact) {
  const int vertex = testing::middle_vertex(mesh);
  const double most = 0.2 * edge;
  const HandleEditOptions options = options_of(1, 0.8 * most), wider = options_of(1, most);
  const EditTargets targets = testing::pull(mesh, vertex, {0.0, 0.0, 0.4 * edge});
  const Positions edited = apply(mesh, solve_handle_edit(mesh, targets, options));
  const Subspace subspace = compute_subspace(mesh, edited, {vertex}, {.dimension = 3});
  ASSERT_GT(subspace.dimension(), 0);
  int beyond = 0;
  const Eigen::Matrix3Xd picks = testing::random_points(3, testing::by_night(8, 4));
  for (int k = 0; k < picks.cols(); ++k) {
    const Eigen::VectorXd values = 0.7 * picks.col(k).head(subspace.dimension());
    const Positions shown = testing::varied(edited, subspace, values);
    const ProjectionResult result = make_exact({mesh, edited, shown}, wider, 0.0, {});
    ASSERT_TRUE(result.report.usable());
    Positions after = shown;
    after(Eigen::all, result.moved) = result.moved_positions;
    EXPECT_LE(testing::largest_slide(mesh, after), most * (1.0 + kRounding)) << k;
    EXPECT_LE(planarity_summary(mesh, after).max_excess, testing::kPromise);
    beyond += testing::largest_slide(mesh, shown) > most ? 1 : 0;
  }
  EXPECT_GT(beyond, 0) << "no setting would exceed the limit without it";
}

INSTANTIATE_TEST_SUITE_P(Samples, SlideLimitOn,
                         ::testing::Values("roof", "vault", "dome", "freeform", "hex", "trihex"),
                         [](const auto& each) { return std::string(each.param); });

TEST(SlideLimitOnImages, HoldsForAllOfThem) {
  const Mesh mesh = testing::sample("roof", 12);
  const double edge = mean_edge_length(mesh), most = 0.1 * edge;
  const auto found = find_symmetry(mesh, {.automatic = true, .elements = {}});
  const auto* const symmetry = std::get_if<MeshSymmetry>(&found);
  ASSERT_NE(symmetry, nullptr);
  HandleEditOptions options;
  options.bounds = {{.name = "slide", .most = most}};
  const int vertex = mesh.vertex_count() * 3 / 10;
  const EditTargets one = testing::pull(mesh, vertex, edge * Eigen::Vector3d(0.3, 0.1, 0.5));
  const auto targets = std::get<EditTargets>(with_images(one, mesh, *symmetry));
  HandleEditSolver solver(mesh, options);
  const HandleEditResult result = solver.solve_symmetric(targets, *symmetry);
  EXPECT_GT(result.report.moved_vertices, 0);
  EXPECT_LE(testing::largest_slide(mesh, apply(mesh, result)), most * (1.0 + kRounding));
  EXPECT_FALSE(result.report.bounds[0].binding.empty());
}

}  // namespace
}  // namespace planish
