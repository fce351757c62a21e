// SPDX-License-Identifier: MIT
/// Reach, keep boundary and softness: what they promise of every edit.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/measures/folds.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// Vertices at least `rings` face rings from the boundary, ascending.
std::vector<int> inner_points(const Mesh& mesh, int rings) {
  const Adjacency adjacency = build_adjacency(mesh);
  std::vector<int> points;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const std::vector<int> near = testing::ring_neighbourhood(mesh, v, rings - 1);
    const bool inner = std::none_of(near.begin(), near.end(), [&](int w) {
      return adjacency.boundary[static_cast<std::size_t>(w)] != 0;
    });
    if (inner) points.push_back(v);
  }
  return points;
}

/// Along the normal of a vertex, by `edges` mean edges.
EditTargets lift(const Mesh& mesh, int vertex, double edges) {
  const Adjacency adjacency = build_adjacency(mesh);
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const int f : adjacency.faces[vertex]) {
    const auto face = mesh.face(f);
    const Eigen::Vector3d a = mesh.positions.col(face[1]) - mesh.positions.col(face[0]);
    const Eigen::Vector3d b = mesh.positions.col(face[2]) - mesh.positions.col(face[0]);
    normal += a.cross(b).normalized();
  }
  return testing::pull(mesh, vertex, edges * mean_edge_length(mesh) * normal.normalized());
}

bool is_inside(const std::vector<int>& moved, const std::vector<int>& region) {
  return std::includes(region.begin(), region.end(), moved.begin(), moved.end());
}

bool holds_boundary(const Mesh& mesh, const std::vector<int>& moved,
                    const std::vector<int>& handles) {
  const Adjacency adjacency = build_adjacency(mesh);
  return std::none_of(moved.begin(), moved.end(), [&](int v) {
    return adjacency.boundary[static_cast<std::size_t>(v)] != 0 &&
           std::find(handles.begin(), handles.end(), v) == handles.end();
  });
}

/// `count` of them, evenly spread.
std::vector<int> some_of(const std::vector<int>& all, std::size_t count) {
  std::vector<int> some;
  for (std::size_t k = 0; k < count; ++k)
    some.push_back(all[(2 * k + 1) * all.size() / (2 * count)]);
  return some;
}

class ReachOn : public ::testing::TestWithParam<const char*> {};

TEST_P(ReachOn, NothingMovesOutsideOrOnAKeptBoundary) {
  const Mesh mesh = testing::sample(GetParam(), 13);
  const int handle = some_of(inner_points(mesh, 2), 1)[0];
  const EditTargets targets = lift(mesh, handle, 0.5);
  for (const int reach : {1, 2, 4}) {
    const std::vector<int> region = testing::ring_neighbourhood(mesh, handle, reach);
    for (const double softness : {0.0, 1.0, 5.5, 10.0}) {
      const HandleEditOptions options{.reach = reach, .keep_boundary = true, .softness = softness};
      const HandleEditResult result = solve_handle_edit(mesh, targets, options);
      EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
      EXPECT_TRUE(is_inside(result.moved, region)) << reach << ' ' << softness;
      EXPECT_TRUE(holds_boundary(mesh, result.moved, {handle})) << reach << ' ' << softness;
    }
  }
}

TEST_P(ReachOn, TheOtherTermsAndTheOtherEngineKeepItToo) {
  const Mesh mesh = testing::sample(GetParam(), 11);
  const int handle = some_of(inner_points(mesh, 2), 1)[0];
  const EditTargets targets = lift(mesh, handle, 0.3);
  const std::vector<int> region = testing::ring_neighbourhood(mesh, handle, 3);
  for (const Sparsity sparsity : {Sparsity::kL21, Sparsity::kL2, Sparsity::kNone}) {
    for (const Engine engine : {Engine::kNewton, Engine::kAugmentedLagrangian}) {
      const HandleEditOptions options{
          .sparsity = sparsity, .reach = 3, .keep_boundary = true, .engine = engine};
      const HandleEditResult result = solve_handle_edit(mesh, targets, options);
      EXPECT_TRUE(is_inside(result.moved, region));
      EXPECT_TRUE(holds_boundary(mesh, result.moved, {handle}));
    }
  }
}

/// Also where the points that may move change between two frames.
TEST_P(ReachOn, EveryFrameOfADragKeepsIt) {
  const Mesh mesh = testing::sample(GetParam(), 13);
  HandleEditSolver solver(mesh, {.reach = 3, .keep_boundary = true, .softness = 5.0});
  for (const int handle : some_of(inner_points(mesh, 2), 3)) {
    const std::vector<int> region = testing::ring_neighbourhood(mesh, handle, 3);
    for (const double edges : {0.05, 0.2, 0.4}) {
      const EditTargets targets = lift(mesh, handle, edges);
      const HandleEditResult result = solver.drag(targets, 1e9);
      EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
      EXPECT_TRUE(is_inside(result.moved, region)) << handle << ' ' << edges;
      EXPECT_TRUE(holds_boundary(mesh, result.moved, {handle})) << handle << ' ' << edges;
    }
  }
}

TEST_P(ReachOn, HeldVerticesAreTheOthers) {
  const Mesh mesh = testing::sample(GetParam(), 13);
  const Adjacency adjacency = build_adjacency(mesh);
  const int handle = some_of(inner_points(mesh, 2), 1)[0];
  EditTargets targets = lift(mesh, handle, 0.3);
  const std::vector<int> region = testing::ring_neighbourhood(mesh, handle, 2);
  const int pin = region.front() == handle ? region.back() : region.front();
  targets.pins = {pin};
  EXPECT_EQ(held_vertices(mesh, targets, {}), targets.pins);
  std::vector<int> expected;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const bool inside = std::binary_search(region.begin(), region.end(), v);
    if (!inside || v == pin || adjacency.boundary[static_cast<std::size_t>(v)] != 0) {
      expected.push_back(v);
    }
  }
  EXPECT_EQ(held_vertices(mesh, targets, {.reach = 2, .keep_boundary = true}), expected);
}

/// Of all samples, over the scale: pulls of a quarter edge, where no panel is spoilt yet.
TEST_P(ReachOn, MoreSoftnessNeverMakesTheSharpestFoldSharper) {
  constexpr double kSeen = 0.1;  // degrees: a solve is not followed closer
  const Mesh mesh = testing::sample(GetParam(), 17);
  const Adjacency adjacency = build_adjacency(mesh);
  for (const int handle : some_of(inner_points(mesh, 3), 3)) {
    const EditTargets targets = lift(mesh, handle, 0.25);
    const std::vector<int> region =
        faces_of(adjacency, testing::ring_neighbourhood(mesh, handle, 4));
    const double before = sharpest_fold(mesh, adjacency, mesh.positions, region).degrees;
    double harder = 180.0;
    for (double softness = kHardest; softness <= kSoftest; softness += 1.0) {
      const HandleEditResult result = solve_handle_edit(
          mesh, targets, {.reach = 4, .keep_boundary = true, .softness = softness});
      const double after = sharpest_fold(mesh, adjacency, apply(mesh, result), region).degrees;
      EXPECT_LE(after, std::max(harder, before) + kSeen) << handle << " at " << softness;
      harder = after;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, ReachOn,
                         ::testing::Values("roof", "vault", "dome", "freeform", "hex", "trihex"));

/// A length measures straight from the handle, and never jumps over what is farther.
TEST(Reach, OfALengthIsABallAroundTheHandles) {
  const Mesh mesh = testing::sample("dome", 15);
  const int handle = testing::middle_vertex(mesh);
  const double length = 2.2 * mean_edge_length(mesh);
  const HandleEditResult result =
      solve_handle_edit(mesh, lift(mesh, handle, 0.4), {.reach_length = length, .softness = 8.0});
  EXPECT_GT(result.moved.size(), 9U);
  for (const int v : result.moved) {
    EXPECT_LE((mesh.positions.col(v) - mesh.positions.col(handle)).norm(), length) << v;
  }
}

TEST(Reach, OfSeveralHandlesIsThatOfAnyOfThem) {
  const Mesh mesh = testing::sample("dome", 21);
  const std::vector<int> handles{5 * 21 + 5, 15 * 21 + 15};
  EditTargets targets = lift(mesh, handles[0], 0.3);
  targets.handles.push_back(lift(mesh, handles[1], 0.3).handles[0]);
  std::vector<int> region = testing::ring_neighbourhood(mesh, handles[0], 3);
  const std::vector<int> other = testing::ring_neighbourhood(mesh, handles[1], 3);
  region.insert(region.end(), other.begin(), other.end());
  std::sort(region.begin(), region.end());
  const HandleEditResult result = solve_handle_edit(mesh, targets, {.reach = 3, .softness = 8.0});
  EXPECT_TRUE(is_inside(result.moved, region));
  EXPECT_LT(result.report.handle_error, 0.3 * mean_edge_length(mesh));
}

/// What is asked for by name is done.
TEST(KeepBoundary, LetsAHandleOnItMoveAndNoOther) {
  const Mesh mesh = testing::triangle_grid(9, 9);
  const EditTargets targets = testing::pull(mesh, 4, {0, 0, 0.5});
  const HandleEditResult result =
      solve_handle_edit(mesh, targets, {.keep_boundary = true, .softness = 5.0});
  EXPECT_TRUE(std::binary_search(result.moved.begin(), result.moved.end(), 4));
  EXPECT_TRUE(holds_boundary(mesh, result.moved, {4}));
}

/// Ten times the pull moves the same points, ten times as far: where there are no panels to hold
/// it.
TEST(Softness, ALargerPullKeepsItsShape) {
  const Mesh mesh = testing::triangle_grid(15, 15);
  const int handle = 7 * 15 + 7;
  const HandleEditOptions options{.reach = 5, .softness = 3.0};
  const auto moves = [&](double height) {
    const HandleEditResult result =
        solve_handle_edit(mesh, testing::pull(mesh, handle, {0, 0, height}), options);
    return Positions((apply(mesh, result) - mesh.positions) / height);
  };
  const Positions small = moves(0.2), large = moves(2.0);
  EXPECT_GT(large.colwise().norm().maxCoeff(), 0.5);
  EXPECT_LT((large - small).colwise().norm().maxCoeff(), 1e-3);
}

TEST(Softness, EveryStepShows) {
  const Mesh mesh = testing::sample("dome", 17);
  const EditTargets targets = lift(mesh, testing::middle_vertex(mesh), 0.4);
  Positions harder = mesh.positions;
  for (double softness = kHardest; softness <= kSoftest; softness += 0.5) {
    const HandleEditResult result =
        solve_handle_edit(mesh, targets, {.reach = 5, .softness = softness});
    const Positions now = apply(mesh, result);
    EXPECT_GT((now - harder).colwise().norm().maxCoeff(), 2e-3 * mean_edge_length(mesh))
        << softness;
    harder = now;
  }
}

}  // namespace
}  // namespace planish
