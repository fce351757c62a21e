// SPDX-License-Identifier: MIT
/// A mesh that is a keep-out itself: no panel of an edit goes through another, none is nearer than
/// the clearance, and where none comes near nothing is different. Distances are measured without
/// the core.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "support/distances.hpp"
#include "support/edit_invariants.hpp"
#include "support/mesh_builders.hpp"
#include "support/obstacles.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kKept = 1e-9;  ///< mean edges: what was promised

HandleEditOptions apart(double clearance = 0.0) {
  HandleEditOptions options;
  options.keep_outs = {*parse_keep_out("self")};
  options.clearance = clearance;
  return options;
}

/// A strip of `rows` × 14 squares of side 1, bent to a U: two flaps, one a `height` above the
/// other.
Mesh two_flaps(int rows, double height) {
  constexpr int kFlap = 6;
  std::vector<Eigen::Vector2d> profile;
  for (int k = kFlap; k > 0; --k) profile.emplace_back(k, height);
  profile.emplace_back(0.0, height);
  profile.emplace_back(-0.5, 0.5 * height);
  for (int k = 0; k <= kFlap; ++k) profile.emplace_back(k, 0.0);
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> faces;
  const int across = rows + 1;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    for (int row = 0; row < across; ++row) points.emplace_back(profile[k].x(), row, profile[k].y());
    const int first = static_cast<int>(k) * across;
    for (int row = 0; k > 0 && row < rows; ++row) {
      faces.push_back(
          {first - across + row, first - across + row + 1, first + row + 1, first + row});
    }
  }
  return testing::make_mesh(points, faces);
}

/// The middle of the upper flap's end, pushed through the lower flap.
constexpr int kTip = 2;

TEST(EditApart, FlapsThatArePushedThroughEachOtherStopAtContact) {
  const Mesh mesh = two_flaps(4, 1.5);
  for (const double clearance : {0.0, 0.2}) {
    for (const Eigen::Vector3d& move :
         {Eigen::Vector3d(0.0, 0.0, -2.5), Eigen::Vector3d(-0.3, 0.2, -4.0),
          Eigen::Vector3d(-2.0, 0.0, -1.8)}) {
      SCOPED_TRACE(::testing::Message() << clearance << ": " << move.transpose());
      const EditTargets targets = testing::pull(mesh, kTip, move);
      const HandleEditResult through = solve_handle_edit(mesh, targets);
      EXPECT_LE(testing::least_panel_distance(mesh, apply(mesh, through), 1.0), clearance)
          << "without it they meet, or nothing is shown here";
      const HandleEditResult held = solve_handle_edit(mesh, targets, apart(clearance));
      EXPECT_TRUE(testing::is_valid_edit(mesh, targets, held));
      const double distance = testing::least_panel_distance(mesh, apply(mesh, held), 1.0);
      std::printf(
          "clearance %g, move %g %g %g: %s, %.3g apart, handle %.3g short (%.3g), %.0f ms (%.0f)\n",
          clearance, move.x(), move.y(), move.z(),
          std::string(status_name(held.report.status)).c_str(), distance, held.report.handle_error,
          through.report.handle_error, 1e3 * held.report.solve_seconds,
          1e3 * through.report.solve_seconds);
      EXPECT_GE(distance, clearance - kKept);
      EXPECT_GT(distance, 0.0);
      EXPECT_LE(distance, clearance + 0.02) << "at contact, not before";
      EXPECT_GT(held.report.moved_vertices, 0);
    }
  }
}

TEST(EditApart, NoFrameOfAFastDragGoesThrough) {
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  const Mesh mesh = two_flaps(4, 1.5);
  HandleEditSolver solver(mesh, apart());
  int followed = 0;
  for (const double depth : {0.4, 1.0, 4.0, 3.0, 0.5, 0.2}) {  // through the flap, and back
    const EditTargets targets = testing::pull(mesh, kTip, {0.0, 0.0, -depth});
    const HandleEditResult frame = solver.drag(targets, kBudget);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, frame));
    const Positions after = apply(mesh, frame);
    EXPECT_GT(testing::least_panel_distance(mesh, after, 1.0), 0.0) << depth;
    for (const int v : frame.moved) {
      const bool upper = v < 7 * 5;
      EXPECT_TRUE(!upper || after(2, v) > 0.0) << depth << ": " << v << " is under the lower flap";
    }
    followed += frame.report.handle_error < 0.5 * depth ? 1 : 0;
  }
  EXPECT_GE(followed, 3);
}

using EditApartOn = testing::OnObstructedMesh;

/// Where no panel comes near another the edit is the same, to the bit.
TEST_P(EditApartOn, ChangesNothingWhereNothingMeets) {
  double with = 0.0, without = 0.0;
  for (const testing::Obstacle& one : testing::obstacles(mesh, 83, testing::by_night(6, 2))) {
    SCOPED_TRACE("vertex " + std::to_string(one.vertex));
    const EditTargets targets = testing::pull(mesh, one.vertex, one.move);
    const HandleEditResult free = solve_handle_edit(mesh, targets);
    const HandleEditResult held = solve_handle_edit(mesh, targets, apart());
    EXPECT_GT(testing::least_panel_distance(mesh, apply(mesh, free), 0.01), 0.0);
    EXPECT_TRUE(testing::same_bits(apply(mesh, free), apply(mesh, held)));
    EXPECT_EQ(held.report.status, free.report.status);
    with += held.report.solve_seconds;
    without += free.report.solve_seconds;
  }
  std::printf("%s: %.2f of the time without\n", GetParam(), with / without);
}

/// Pulls of up to two mean edges, and a clearance that panels beside the next have not: what had it
/// keeps it, what had not stays apart.
TEST_P(EditApartOn, KeepsTheClearance) {
  const int edits = testing::by_night(3, 1);
  int certified = 0, moved = 0, nearer_without = 0;
  const double edge = mean_edge_length(mesh);
  for (const double share : {0.1, 0.3}) {
    for (const testing::Obstacle& one : testing::obstacles(mesh, 89, edits)) {
      SCOPED_TRACE("vertex " + std::to_string(one.vertex));
      const EditTargets targets = testing::pull(mesh, one.vertex, 1.5 * one.move);
      const auto nearest = [&](const HandleEditResult& result, double clearance) {
        return testing::least_panel_distance(mesh, apply(mesh, result), share * edge, clearance);
      };
      nearer_without += nearest(solve_handle_edit(mesh, targets), share * edge) < share ? 1 : 0;
      const HandleEditResult held = solve_handle_edit(mesh, targets, apart(share * edge));
      EXPECT_TRUE(testing::is_valid_edit(mesh, targets, held));
      EXPECT_GE(nearest(held, share * edge), share - kKept);
      EXPECT_GT(nearest(held, 0.0), 0.0);
      certified += held.report.status == SolveStatus::kConverged ? 1 : 0;
      moved += held.report.moved_vertices > 0 ? 1 : 0;
    }
  }
  std::printf("%s: %d certified, %d moved of %d; %d nearer without\n", GetParam(), certified, moved,
              2 * edits, nearer_without);
  // One of mixed345_airport finds no way in WebAssembly, whose last bits differ, and stays.
  EXPECT_GE(moved, 2 * edits - 1);
  // docs/decisions/0040-keep-outs.md: all but three of 120, which are of mixed345_airport.
  EXPECT_GE(certified, edits);
}

INSTANTIATE_TEST_SUITE_P(Meshes, EditApartOn, ::testing::ValuesIn(testing::kObstructedMeshes),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace planish
