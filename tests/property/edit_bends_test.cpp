// SPDX-License-Identifier: MIT
/// Edits of meshes whose panels are bent and stay so: none bends more, what is flat stays flat.
/// [MET-6]
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr int kSide = 14;

/// Nets that run along no conjugate directions, by name: no flat mesh is near them.
Mesh bent_mesh(const std::string& name) {
  if (name == "saddle") {
    return testing::quad_grid(kSide, kSide, [](double x, double y) { return 0.05 * x * y; });
  }
  if (name == "waves") {
    return testing::quad_grid(kSide, kSide,
                              [](double x, double y) { return 0.5 * std::sin(0.6 * (x + y)); });
  }
  // Flat panels to the left of the middle, bent ones to its right.
  return testing::quad_grid(kSide, kSide, [](double x, double y) {
    const double beyond = std::max(0.0, x - 0.5 * kSide);
    return 0.02 * (x * x + y * y) + 0.06 * beyond * y;
  });
}

HandleEditOptions kept_bends(const Mesh& mesh) {
  HandleEditOptions options;
  options.attraction = 1e4;
  options.reach = 6;
  options.softness = 5.0;
  options.keep_boundary = true;
  options.keep_bends = true;
  options.tolerance = 1.001 * planarity_summary(mesh).max;
  return options;
}

/// No panel is bent beyond what it was, and everything that is not reported as moved keeps its
/// bits. @returns how many panels changed
int expect_none_bends_more(const Mesh& mesh, const HandleEditResult& result) {
  const Positions after = apply(mesh, result);
  int changed = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const double before = face_planarity(mesh.positions, mesh.face(f)).mm_per_m;
    const double now = face_planarity(after, mesh.face(f)).mm_per_m;
    EXPECT_LE(now, std::max(before, PlanarPolygon::kTolerance) + PlanarPolygon::kTolerance) << f;
    const std::span<const int> corners = mesh.face(f);
    changed += std::any_of(corners.begin(), corners.end(), [&](int v) {
      return std::binary_search(result.moved.begin(), result.moved.end(), v);
    });
  }
  EXPECT_EQ(moved_vertex_count(mesh.positions, after), static_cast<int>(result.moved.size()));
  return changed;
}

std::vector<int> some_inner_vertices() {
  std::vector<int> vertices;
  for (const int place : {3, 5, 7, 9, 10}) vertices.push_back(place * kSide + (3 * place) % kSide);
  return vertices;
}

class EditBends : public ::testing::TestWithParam<std::string> {};

TEST_P(EditBends, NoPanelBendsMoreAndTheEditIsCertified) {
  const Mesh mesh = bent_mesh(GetParam());
  ASSERT_GT(planarity_summary(mesh).max, 20.0);
  HandleEditSolver solver(mesh, kept_bends(mesh));
  for (const int v : some_inner_vertices()) {
    for (const double lift : {-0.3, 0.3}) {
      const HandleEditResult result = solver.solve(testing::pull(mesh, v, {0.0, 0.0, lift}));
      EXPECT_EQ(result.report.status, SolveStatus::kConverged) << v << " by " << lift;
      EXPECT_LT(result.report.handle_error, std::abs(lift)) << v << " by " << lift;
      EXPECT_GT(expect_none_bends_more(mesh, result), 0);
    }
  }
}

/// Without it the panels that move become flat: the promise is not kept by chance.
TEST_P(EditBends, IsNotWhatAToleranceDoes) {
  const Mesh mesh = bent_mesh(GetParam());
  HandleEditOptions options = kept_bends(mesh);
  const EditTargets targets = testing::pull(mesh, 7 * kSide + 10, {0.0, 0.0, 0.3});
  const auto most_changed = [&] {
    const HandleEditResult result = solve_handle_edit(mesh, targets, options);
    const Positions after = apply(mesh, result);
    double most = 0.0;
    for (int f = 0; f < mesh.face_count(); ++f) {
      const double before = face_planarity(mesh.positions, mesh.face(f)).mm_per_m;
      most = std::max(most, before - face_planarity(after, mesh.face(f)).mm_per_m);
    }
    return result.moved.empty() ? 1e9 : most;
  };
  const double kept = most_changed();
  options.keep_bends = false;
  EXPECT_GT(most_changed(), 2.0 * kept);
}

TEST_P(EditBends, EveryFrameOfADragKeepsThem) {
  const Mesh mesh = bent_mesh(GetParam());
  HandleEditSolver solver(mesh, kept_bends(mesh));
  const int v = 7 * kSide + 9;
  constexpr int kFrames = 24;
  std::size_t moved = 0;
  HandleEditResult last;
  for (int k = 1; k <= kFrames; ++k) {
    const double share = static_cast<double>(k) / kFrames;
    last = solver.drag(testing::pull(mesh, v, {0.1 * share, 0.0, 0.4 * share}), 1e9);
    (void)expect_none_bends_more(mesh, last);
    moved = std::max(moved, last.moved.size());
  }
  EXPECT_GT(moved, 10u);
  EXPECT_LT(last.report.handle_error, 0.5 * std::hypot(0.1, 0.4));
}

/// Whatever was solved before, and under which options.
TEST_P(EditBends, DependsOnWhatIsAskedAlone) {
  const Mesh mesh = bent_mesh(GetParam());
  const EditTargets targets = testing::pull(mesh, 7 * kSide + 10, {0.0, 0.0, 0.4});
  HandleEditOptions near = kept_bends(mesh);
  near.reach = 3;
  HandleEditSolver solver(mesh, near);
  (void)solver.solve(targets);
  (void)solver.drag(testing::pull(mesh, 7 * kSide + 8, {0.1, 0.0, 0.3}), 1e9);
  solver.set_options(kept_bends(mesh));
  const HandleEditResult later = solver.solve(targets);
  const HandleEditResult first = solve_handle_edit(mesh, targets, kept_bends(mesh));
  EXPECT_EQ(later.moved, first.moved);
  EXPECT_EQ(later.moved_positions, first.moved_positions);
}

INSTANTIATE_TEST_SUITE_P(Bent, EditBends, ::testing::Values("saddle", "waves", "half"));

/// Panels with more corners: each has its own bend, from a file of another program.
TEST(EditBends, HoldForPanelsOfSixCorners) {
  Mesh mesh = testing::sample("hex", 8);
  const double edge = mean_edge_length(mesh);
  mesh.positions.row(2) += 0.01 * edge * testing::random_vector(3, mesh.vertex_count()).transpose();
  ASSERT_GT(planarity_summary(mesh).max, 20.0);
  const HandleEditOptions options = kept_bends(mesh);
  const int v = testing::middle_vertex(mesh);
  const HandleEditResult result =
      solve_handle_edit(mesh, testing::pull(mesh, v, {0.0, 0.0, 0.1 * edge}), options);
  (void)expect_none_bends_more(mesh, result);
}

}  // namespace
}  // namespace planish
