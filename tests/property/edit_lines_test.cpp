// SPDX-License-Identifier: MIT
/// What lines of the mesh hold: points slide on the boundary's outline and on polylines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/adjacency.hpp"
#include "support/edit_invariants.hpp"
#include "support/scenes.hpp"
#include "support/supported_edit.hpp"

namespace planish {
namespace {

using testing::support;

/// Pulls of an interior and of a boundary point, with the boundary on its outline.
class EditOutline : public testing::SupportedEdit {
 protected:
  [[nodiscard]] EditTargets pulled(double move) const {
    EditTargets targets = lifted(move);
    const std::vector<int> rim = boundary_vertices(mesh);
    const int on_rim = rim[rim.size() / 3];
    targets.handles.push_back(
        {on_rim, mesh.positions.col(on_rim) + Eigen::Vector3d(move, 0.7 * move, 0.2 * move)});
    targets.supports = {support("outline:boundary")};
    return targets;
  }
  [[nodiscard]] double off(const EditTargets& targets, const HandleEditResult& result) const {
    const Positions after = apply(mesh, result);
    return largest_distance(targets.supports.front(), mesh, after) / mean_edge_length(mesh);
  }
};

/// With the boundary kept an edit is on its outline as well. Each of these was stuck beside it.
TEST(EditsOnAnOutline, EndNoHigherThanWithTheBoundaryKept) {
  struct Pull {
    int vertex;
    double edges;
  };
  const Mesh mesh = testing::sample("freeform", 16);
  for (const auto& [vertex, edges] : {Pull{183, -1.5}, Pull{71, -1.5}, Pull{182, 1.0}}) {
    SCOPED_TRACE(vertex);
    EditTargets targets = testing::pull(mesh, vertex, edges * Eigen::Vector3d(0.2, 0.1, 1.0));
    const HandleEditResult kept =
        solve_handle_edit(mesh, targets, {.reach = 6, .keep_boundary = true, .softness = 5.0});
    targets.supports = {support("outline:boundary")};
    const HandleEditResult free = solve_handle_edit(mesh, targets, {.reach = 6, .softness = 5.0});
    EXPECT_LE(free.report.objective.total(), (1.0 + 1e-6) * kept.report.objective.total());
    EXPECT_EQ(free.report.optimality && free.report.optimality->met(),
              free.report.status == SolveStatus::kConverged);
  }
}

TEST_P(EditOutline, HoldsInEveryEdit) {
  int converged = 0;
  for (const double move : {0.2, 0.5, 1.0, 2.0}) {
    const EditTargets targets = pulled(move);
    const HandleEditResult result = solve(targets);
    EXPECT_LE(off(targets, result), 1e-9) << "moved by " << move;
    EXPECT_GT(result.report.moved_vertices, 0);
    converged += result.report.status == SolveStatus::kConverged ? 1 : 0;
  }
  EXPECT_GE(converged, 2);
}

TEST_P(EditOutline, HoldsInEveryFrameOfADrag) {
  constexpr int kFrames = 24;
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  HandleEditSolver solver(mesh, {});
  for (int frame = 1; frame <= kFrames; ++frame) {
    const double move = 1.2 * std::sin(0.26 * frame);  // there, back, and to the other side
    const EditTargets targets = pulled(move);
    const HandleEditResult result = solver.drag(targets, kBudget);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result)) << "frame " << frame;
    EXPECT_LE(off(targets, result), 1e-9) << "frame " << frame;
  }
}

/// A point between two sides of a polygon goes along one of them, and not beyond a sharp corner.
TEST(EditOutlineOf, APolygonStopsAtItsCorners) {
  const Mesh mesh = testing::quad_grid(9, 9);
  EditTargets targets = testing::pull(mesh, 4, {9.0, -2.0, 0.0});
  targets.supports = {support("outline:boundary")};
  HandleEditOptions options;
  options.keep_shape = false;
  const Positions after = apply(mesh, solve_handle_edit(mesh, targets, options));
  EXPECT_EQ(after(1, 4), 0.0);
  EXPECT_EQ(after(2, 4), 0.0);
  EXPECT_GT(after(0, 4), 5.0) << "past the next points of its side";
  EXPECT_LE(after(0, 4), 8.0);
  for (const int corner : {0, 8, 72, 80}) EXPECT_EQ(after.col(corner), mesh.positions.col(corner));
}

/// Pulls of a point in the middle of a line of the mesh, along it and off it, and of one beside.
class EditPolyline : public testing::SupportedEdit {
 protected:
  EditPolyline() : adjacency(build_adjacency(mesh)) {
    const int next = adjacency.neighbours[handle].front();
    const std::vector<int> back = walk(next);
    line.assign(back.rbegin(), back.rend());
    line.push_back(handle);
    for (const int v : walk(straight_on(next, handle, back), back)) line.push_back(v);
  }

  /// The neighbour of `at` straight ahead for who comes from `from`; −1 where nothing lies ahead.
  [[nodiscard]] int straight_on(int from, int at, const std::vector<int>& taken) const {
    int best = -1;
    double most = 0.0;
    for (const int v : adjacency.neighbours[at]) {
      const double ahead = edge(from, at).dot(edge(at, v).normalized());
      if (ahead > most && std::count(taken.begin(), taken.end(), v) == 0) best = v, most = ahead;
    }
    return best;
  }
  /// From the handle over `next` and on, as straight as edges go, five points at most.
  [[nodiscard]] std::vector<int> walk(int next, std::vector<int> taken = {}) const {
    std::vector<int> way{handle, next};
    taken.push_back(handle);
    while (way.size() < 6) {
      taken.push_back(way.back());
      const int on = straight_on(way[way.size() - 2], way.back(), taken);
      if (on < 0) break;
      way.push_back(on);
    }
    way.erase(way.begin());
    return way;
  }
  [[nodiscard]] Eigen::Vector3d edge(int from, int to) const {
    return mesh.positions.col(to) - mesh.positions.col(from);
  }
  [[nodiscard]] PointSupport polyline() const {
    std::string text = "polyline:";
    for (const int v : line) {
      text += std::to_string(v);
      text += ',';
    }
    text.pop_back();
    return support(text);
  }
  [[nodiscard]] EditTargets pulled(double move) const {
    EditTargets targets = lifted(move);
    const Eigen::Vector3d along = edge(handle, line[6]).normalized();
    targets.handles.front().target =
        mesh.positions.col(handle) + move * along + Eigen::Vector3d(0.0, 0.0, 0.3 * move);
    targets.supports = {polyline()};
    return targets;
  }

  Adjacency adjacency;
  std::vector<int> line;  ///< the handle is its sixth point
};

TEST_P(EditPolyline, HoldsInEveryEdit) {
  int converged = 0, slid = 0;
  for (const double move : {0.2, 0.5, 1.0, -0.5}) {
    const EditTargets targets = pulled(move);
    const HandleEditResult result = solve(targets);
    const Positions after = apply(mesh, result);
    EXPECT_LE(largest_distance(targets.supports.front(), mesh, after) / mean_edge_length(mesh),
              1e-9)
        << "moved by " << move;
    for (const int end : {line.front(), line.back()}) {
      EXPECT_EQ(after.col(end), mesh.positions.col(end)) << "an end rests";
    }
    slid += way_of(result, handle) > 0.05 ? 1 : 0;
    converged += result.report.status == SolveStatus::kConverged ? 1 : 0;
  }
  EXPECT_GE(converged, 3);
  // Lines of hexagons turn by 60° at every point: all of them are corners.
  const bool all_corners = std::string(GetParam()) == "hex";
  EXPECT_EQ(slid, all_corners ? 0 : 4);
}

TEST_P(EditPolyline, HoldsInEveryFrameOfADrag) {
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  HandleEditSolver solver(mesh, {});
  for (int frame = 1; frame <= 24; ++frame) {
    EditTargets targets = pulled(std::sin(0.26 * frame));
    targets.supports.push_back(support("outline:boundary"));
    const HandleEditResult result = solver.drag(targets, kBudget);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result)) << "frame " << frame;
    for (const PointSupport& one : targets.supports) {
      EXPECT_LE(largest_distance(one, mesh, apply(mesh, result)) / mean_edge_length(mesh), 1e-9)
          << "frame " << frame;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, EditPolyline, ::testing::Values("roof", "dome", "hex", "trihex"),
                         &testing::sample_name);

INSTANTIATE_TEST_SUITE_P(Samples, EditOutline, ::testing::Values("roof", "dome", "hex", "trihex"),
                         &testing::sample_name);

}  // namespace
}  // namespace planish
