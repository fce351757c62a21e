// SPDX-License-Identifier: MIT
/// Points that stand on something, in variations of an edit and in meshes that are made flat.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "planish/edit/kept_by_variations.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/projection/projection.hpp"
#include "planish/variations/exact_variation.hpp"
#include "planish/variations/subspace.hpp"
#include "support/supported_edit.hpp"

namespace planish {
namespace {

using testing::sample_name;
using testing::support;

constexpr double kOffLines = 1e-9;     ///< mean edges
constexpr double kOffSurfaces = 1e-7;  ///< mean edges

double most_off(const std::string& text) {
  return text.starts_with("surface") ? kOffSurfaces : kOffLines;
}

/// An edit of a boundary point, the boundary on what a test says, and variations of it.
class SupportedVariations : public ::testing::TestWithParam<const char*> {
 protected:
  SupportedVariations() : base(testing::sample(GetParam(), 16)), rim(boundary_vertices(base)) {}

  void edit_on(const std::string& text) {
    targets = testing::pull(base, rim[rim.size() / 3], {0.4, 0.3, 0.05});
    targets.supports = {support(text)};
    edited = apply(base, solve_handle_edit(base, targets));
    keeps = kept_by_variations(base, targets, {});
    family = compute_subspace(base, edited, {}, {.dimension = 3}, keeps);
  }

  [[nodiscard]] double off(const Positions& shape) const {
    return largest_distance(targets.supports.front(), base, shape) / mean_edge_length(base);
  }
  [[nodiscard]] Positions slid(double share) const {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(family.dimension());
    for (Eigen::Index k = 0; k < values.size(); ++k) values[k] = share * (k % 2 == 0 ? 1.0 : -0.7);
    return testing::varied(edited, family, values);
  }
  /// How many points of the boundary the family moves.
  [[nodiscard]] std::ptrdiff_t movers_on_rim() const {
    return std::count_if(rim.begin(), rim.end(), [&](int v) {
      return std::binary_search(family.support.begin(), family.support.end(), v);
    });
  }
  [[nodiscard]] Positions exact_of(const Positions& shown, ProjectionResult& result) const {
    result = make_exact({base, edited, shown}, {}, 0.0, keeps);
    Positions shape = shown;
    shape(Eigen::all, result.moved) = result.moved_positions;
    return shape;
  }

  Mesh base;
  std::vector<int> rim;
  EditTargets targets;
  Positions edited;
  KeptByVariations keeps;
  Subspace family;
};

TEST_P(SupportedVariations, KeepTheBitsOfLevels) {
  edit_on("level:boundary");
  ASSERT_GT(family.dimension(), 0);
  EXPECT_GT(movers_on_rim(), 0) << "along the level";
  for (const double share : {-1.0, 0.4, 1.0}) {
    const Positions shown = slid(share);
    ProjectionResult result;
    const Positions exact = exact_of(shown, result);
    for (const int v : rim) {
      EXPECT_EQ(shown(2, v), base.positions(2, v)) << v;
      EXPECT_EQ(exact(2, v), base.positions(2, v)) << v;
    }
  }
}

/// What sliders show leaves a surface by the square of the way, and a side of an outline not at
/// all.
TEST_P(SupportedVariations, AreTangentToWhatPointsStandOn) {
  edit_on("surface:boundary");
  ASSERT_GT(family.dimension(), 0);
  EXPECT_GT(movers_on_rim(), 0);
  const double edit = off(edited);
  EXPECT_LT(off(slid(0.02)) - edit, 0.3 * (off(slid(0.04)) - edit) + 1e-9);
}

TEST_P(SupportedVariations, AreExactlyThereOnceMadeExact) {
  int exact_ones = 0;
  int moving = 0;
  for (const std::string text : {"level:boundary", "outline:boundary", "surface:boundary"}) {
    edit_on(text);
    moving += movers_on_rim() > 0 ? 1 : 0;
    for (const double share : {0.5, -1.0}) {
      ProjectionResult result;
      const Positions exact = exact_of(slid(share), result);
      ASSERT_TRUE(result.report.usable()) << text << status_name(result.report.status);
      EXPECT_LE(planarity_summary(base, exact).max, testing::kPromise) << text;
      EXPECT_LE(off(exact), std::max(most_off(text), off(edited))) << text << " " << share;
      exact_ones += result.report.status == SolveStatus::kConverged ? 1 : 0;
    }
  }
  EXPECT_GE(moving, 2) << "one of three at most has a boundary that stays";
  EXPECT_GE(exact_ones, 3) << "of six";
}

INSTANTIATE_TEST_SUITE_P(Samples, SupportedVariations,
                         ::testing::Values("roof", "vault", "dome", "freeform", "hex", "trihex"),
                         sample_name);

/// Points on an outline that the edit did not move: the polygon has no tangent at them.
TEST(SupportedVariationsOf, AnUnmovedOutlineLeaveItAlone) {
  const Mesh base = testing::sample("vault", 16);
  EditTargets targets = testing::pull(base, testing::middle_vertex(base), {0.0, 0.0, 0.6});
  targets.supports = {support("outline:boundary")};
  HandleEditOptions options;
  options.reach = 3;
  const Positions edited = apply(base, solve_handle_edit(base, targets, options));
  const Subspace family = compute_subspace(base, edited, {}, {.dimension = 3, .reach = 12},
                                           {.supports = targets.supports});
  ASSERT_EQ(family.dimension(), 3);
  for (const int v : boundary_vertices(base)) {
    EXPECT_FALSE(std::binary_search(family.support.begin(), family.support.end(), v)) << v;
  }
}

/// A mesh whose points were moved at random, made flat on what a test says.
class SupportedProjection : public ::testing::TestWithParam<const char*> {
 protected:
  SupportedProjection() : flat(testing::sample(GetParam(), 16)), mesh(flat) {
    constexpr double kNoise = 0.02;
    mesh.positions += kNoise * testing::random_points(7, mesh.vertex_count());
  }

  struct Made {
    Positions shape;
    ProjectionResult result;
    double off = 0.0;  ///< mean edges
  };
  [[nodiscard]] Made made(const std::string& text, ProjectionOptions options) const {
    options.supports = {support(text)};
    Made made{mesh.positions, project_to_planar(mesh, options), 0.0};
    made.shape(Eigen::all, made.result.moved) = made.result.moved_positions;
    made.off =
        largest_distance(options.supports.front(), mesh, made.shape) / mean_edge_length(mesh);
    return made;
  }

  Mesh flat;
  Mesh mesh;
};

TEST_P(SupportedProjection, KeepsPointsOnWhatTheyStandOn) {
  // Hexagons turn by 60° at every point of their outline, so that nothing slides along it.
  const bool hexagons = std::string(GetParam()).find("hex") != std::string::npos;
  for (const std::string text : {"level:boundary", "outline:boundary", "surface:boundary"}) {
    if (hexagons && text.starts_with("outline")) continue;
    for (const double smooth : {0.0, 10.0}) {
      const Made one = made(text, {.fairness_weight = smooth});
      EXPECT_EQ(one.result.report.status, SolveStatus::kConverged) << text << " " << smooth;
      EXPECT_LE(planarity_summary(mesh, one.shape).max, testing::kPromise) << text;
      EXPECT_LE(one.off, most_off(text)) << text << " " << smooth;
      EXPECT_GT(one.result.max_move, 0.0);
    }
  }
}

TEST_P(SupportedProjection, CostsDistanceAndLessThanPins) {
  const std::vector<int> rim = boundary_vertices(mesh);
  const ProjectionOptions nearest{.keep_shape = false};
  const double freely = project_to_planar(mesh, nearest).rms_move;
  const double supported = made("level:boundary", nearest).result.rms_move;
  const ProjectionResult pinned = project_to_planar(mesh, nearest, rim);
  EXPECT_GE(supported, freely);
  const bool can_be_pinned = std::string(GetParam()) != "hex";
  EXPECT_EQ(pinned.failing_faces.empty(), can_be_pinned);
  if (can_be_pinned) {
    EXPECT_LE(supported, pinned.rms_move);
  }
}

TEST_P(SupportedProjection, KeepsBitsOfLevelsOnTheWayToFlat) {
  const Made one = made("level:boundary", {.fairness_weight = 10.0, .within = 0.02});
  EXPECT_LE(one.result.max_move, 0.02);
  EXPECT_LT(planarity_summary(mesh, one.shape).max, planarity_summary(mesh).max);
  for (const int v : boundary_vertices(mesh)) EXPECT_EQ(one.shape(2, v), mesh.positions(2, v));
}

INSTANTIATE_TEST_SUITE_P(Samples, SupportedProjection,
                         ::testing::Values("roof", "vault", "dome", "freeform", "hex", "trihex"),
                         sample_name);

TEST(SupportedProjectionRules, AreSaid) {
  ProjectionOptions options;
  options.supports = {support("level:boundary")};
  EXPECT_EQ(find_problem(options), std::nullopt);
  options.engine = Engine::kAugmentedLagrangian;
  EXPECT_EQ(find_problem(options), "supports: the engine alm knows none; they need newton");
  options.engine = Engine::kNewton;
  options.supports = {support("surface:boundary")};
  options.within = 0.1;
  EXPECT_EQ(find_problem(options),
            "support: points on a surface take no within, and no panels that stay less flat");
  options.within = 0.0;
  EXPECT_EQ(find_problem(options), std::nullopt);
}

}  // namespace
}  // namespace planish
