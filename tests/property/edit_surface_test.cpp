// SPDX-License-Identifier: MIT
/// What a surface holds: points slide along the mesh's own, or along a model's, at the height that
/// they have in the base; some of them, or all.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/adjacency.hpp"
#include "support/edit_invariants.hpp"
#include "support/mesh_builders.hpp"
#include "support/obstacles.hpp"
#include "support/supported_edit.hpp"

namespace planish {
namespace {

using testing::support;

constexpr double kHeld = 1e-7;  ///< mean edges off a surface

class EditSurface : public testing::SupportedEdit {};

/// The boundary on it, and a point amid others.
TEST_P(EditSurface, KeepsHeights) {
  int certified = 0;
  const double edge = mean_edge_length(mesh);
  const int rim = boundary_vertices(mesh)[5];
  for (const double length : {0.2, 0.5, 1.0}) {
    for (const int vertex : {rim, handle}) {
      const PointSupport surface =
          support("surface:" + (vertex == rim ? "boundary" : std::to_string(vertex)));
      EditTargets targets = testing::pull(mesh, vertex, length * edge * kAlong);
      const double free = way_of(solve(targets), vertex);
      targets.supports = {surface};
      const HandleEditResult result = solve(targets);
      certified += result.report.status == SolveStatus::kConverged ? 1 : 0;
      EXPECT_LE(largest_distance(surface, mesh, apply(mesh, result)), kHeld * edge)
          << vertex << " by " << length;
      EXPECT_GT(way_of(result, vertex), 0.5 * free) << vertex << " by " << length;
    }
  }
  // One less than here: where rounding differs, another one may stop before it is there.
  EXPECT_GE(certified, 5);
}

/// @param points as in "surface:POINTS" @returns how far the vertex went in the end
double drag_along(const Mesh& mesh, int vertex, const Eigen::Vector3d& way,
                  const std::string& points) {
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  constexpr int kFrames = 20;
  const PointSupport surface = support("surface:" + points);
  HandleEditSolver solver(mesh, {});
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  for (int frame = 1; frame <= kFrames; ++frame) {
    EditTargets targets = testing::pull(mesh, vertex, (0.05 * frame) * way);
    targets.supports = {surface};
    const HandleEditResult result = solver.drag(targets, kBudget);
    EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
    const Positions shape = apply(mesh, result);
    EXPECT_LE(largest_distance(surface, mesh, shape), kHeld * mean_edge_length(mesh)) << frame;
    moved = shape.col(vertex) - mesh.positions.col(vertex);
  }
  return moved.norm();
}

TEST_P(EditSurface, NoFrameOfADragLeavesIt) {
  const double edge = mean_edge_length(mesh);
  const int rim = boundary_vertices(mesh)[5];
  EXPECT_GT(drag_along(mesh, rim, edge * kAlong, "boundary"), 0.2 * edge);
  EXPECT_GT(drag_along(mesh, handle, edge * kAlong, "all"), 0.2 * edge);
}

/// The mesh as a surface in the words of a support. @param triangles its panels cut into them
std::string model_of(const Mesh& mesh, bool triangles) {
  std::string model = "surface=";
  for (const auto point : mesh.positions.colwise()) {
    if (model.back() != '=') model += ';';
    char one[80];
    std::snprintf(one, sizeof one, "%.17g,%.17g,%.17g", point[0], point[1], point[2]);
    model += one;
  }
  char mark = '/';
  const auto add = [&](std::span<const int> panel) {
    for (const int v : panel) {
      model += mark;
      model += std::to_string(v);
      mark = ',';
    }
    mark = ';';
  };
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (!triangles) add(face);
    for (std::size_t k = 1; triangles && k + 1 < face.size(); ++k) {
      add(std::array{face[0], face[k], face[k + 1]});
    }
  }
  return model;
}

TEST_P(EditSurface, AModelIsAsGoodAsTheMesh) {
  const int rim = boundary_vertices(mesh)[5];
  EditTargets targets = testing::pull(mesh, rim, 0.5 * mean_edge_length(mesh) * kAlong);
  targets.supports = {support("surface:boundary")};
  const Positions own = apply(mesh, solve(targets));
  targets.supports = {support(model_of(mesh, false) + ":boundary")};
  EXPECT_TRUE(testing::same_bits(own, apply(mesh, solve(targets))));
  targets.supports = {support(model_of(mesh, true) + ":boundary")};
  const HandleEditResult result = solve(targets);
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
  EXPECT_LE(largest_distance(targets.supports[0], mesh, apply(mesh, result)),
            kHeld * mean_edge_length(mesh));
}

/// Points that rest on a plane and stand on a surface, or on none, beside each other.
TEST_P(EditSurface, HoldsBesideAKeepOut) {
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  const double edge = mean_edge_length(mesh), top = mesh.positions(2, handle);
  const Eigen::Vector3d way = edge * Eigen::Vector3d(0.3, 0.2, 0.5);
  for (const char* points : {"boundary", "all"}) {
    char plane[40];
    std::snprintf(plane, sizeof plane, "above=%.17g", top);
    HandleEditOptions options;
    options.keep_outs = {*parse_keep_out(plane)};
    HandleEditSolver solver(mesh, options);
    const PointSupport surface = support(std::string("surface:") + points);
    for (int frame = 1; frame <= 8; ++frame) {
      EditTargets targets = testing::pull(mesh, handle, (0.1 * frame) * way);
      targets.supports = {surface};
      const Positions shape = apply(mesh, solver.drag(targets, kBudget));
      EXPECT_TRUE(shape.allFinite());
      EXPECT_LE(shape(2, handle), top + 1e-9 * edge) << points << " frame " << frame;
      EXPECT_LE(largest_distance(surface, mesh, shape), kHeld * edge) << points << " " << frame;
    }
  }
}

TEST_P(EditSurface, RefusesWhatItCannotHold) {
  const auto said = [&](const std::vector<PointSupport>& supports, const std::string& words) {
    return find_problem(supports, mesh).value_or("").starts_with("supports: surface: " + words);
  };
  const std::string first = "vertex " + std::to_string(boundary_vertices(mesh)[0]) + " ";
  const std::string far = "surface=0,0,900;1,0,900;1,1,900/0,1,2:boundary";
  EXPECT_TRUE(said({support("surface:boundary"), support("outline:boundary")}, first));
  EXPECT_TRUE(said({support(far)}, first));
}

INSTANTIATE_TEST_SUITE_P(Samples, EditSurface, ::testing::Values("roof", "dome", "hex", "trihex"),
                         testing::sample_name);

class EditOnASurface : public testing::OnObstructedMesh {
 protected:
  /// Edits of six points along the surface, all points on it. @returns how many are certified
  int certified_of_six(const HandleEditOptions& options) {
    const double edge = mean_edge_length(mesh);
    const PointSupport surface = support("surface:all");
    HandleEditSolver solver(mesh, options);
    int certified = 0;
    for (int k = 1; k <= 6; ++k) {
      const int handle = mesh.vertex_count() * k / 7;
      const Eigen::Vector3d way{k % 2 == 0 ? -0.8 : 0.8, 0.6, 0.2 * (k % 3 - 1)};
      EditTargets targets = testing::pull(mesh, handle, (0.3 * edge) * way);
      targets.supports = {surface};
      const HandleEditResult result = solver.solve(targets);
      EXPECT_TRUE(testing::is_valid_edit(mesh, targets, result));
      EXPECT_LE(largest_distance(surface, mesh, apply(mesh, result)), kHeld * edge) << handle;
      EXPECT_GT(result.report.moved_vertices, 0) << handle;
      certified += result.report.status == SolveStatus::kConverged ? 1 : 0;
    }
    std::printf("%s: %d of 6 certified\n", GetParam(), certified);
    return certified;
  }
};

/// As the page edits: a few panels around the handle, softly. `pq_gitter` is no surface: it has
/// sharp edges all over, two of six end at `iteration_limit`, and one keeps its heights to 10⁻⁶
/// only.
TEST_P(EditOnASurface, AllPointsStay) {
  if (std::string_view(GetParam()) == "pq_gitter") GTEST_SKIP() << "sharp edges all over";
  HandleEditOptions options;
  options.softness = 5.0;
  options.reach = 6;
  EXPECT_GE(certified_of_six(options), 5);
}

/// With the paper's weights: few points move, as sharply as may be.
TEST_P(EditOnASurface, AllPointsStayInSharpEdits) {
  if (std::string_view(GetParam()).find('_') != std::string_view::npos) {
    GTEST_SKIP() << "seconds an edit";
  }
  EXPECT_GE(certified_of_six({}), std::string_view(GetParam()) == "hex" ? 3 : 5);
}

INSTANTIATE_TEST_SUITE_P(Meshes, EditOnASurface, ::testing::ValuesIn(testing::kObstructedMeshes),
                         testing::sample_name);

}  // namespace
}  // namespace planish
