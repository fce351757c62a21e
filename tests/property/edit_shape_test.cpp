// SPDX-License-Identifier: MIT
/// What keeps its shape: no edit makes a panel concave, crossing, turned over or collapsed.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/io/obj.hpp"
#include "planish/projection/planarising.hpp"
#include "support/edit_invariants.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

int spoilt_panels(const Mesh& mesh, const HandleEditResult& result) {
  return testing::spoilt_count(mesh, apply(mesh, result));
}

/// The least share of its size that a corner is left with, straight ones left out, by its own code.
double least_share(const Mesh& mesh, const Positions& after) {
  double least = 1.0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const std::size_t n = face.size();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < n; ++k) {
      normal += mesh.positions.col(face[k]).cross(mesh.positions.col(face[(k + 1) % n]));
    }
    normal.normalize();
    for (std::size_t k = 0; k < n; ++k) {
      const auto size = [&](const Positions& p) {
        const Eigen::Vector3d in = p.col(face[k]) - p.col(face[(k + n - 1) % n]);
        const Eigen::Vector3d out = p.col(face[(k + 1) % n]) - p.col(face[k]);
        return std::pair{normal.dot(in.cross(out)), in.norm() * out.norm()};
      };
      const auto [before, lengths] = size(mesh.positions);
      if (std::abs(before) > 2e-3 * lengths) least = std::min(least, size(after).first / before);
    }
  }
  return least;
}

class EditShape : public ::testing::TestWithParam<const char*> {
 protected:
  EditShape() : mesh(testing::sample(GetParam(), testing::by_night(16, 12))) {}

  /// The middle, a point beside it and one near a corner, up and sideways; not so far every night
  /// alone.
  [[nodiscard]] std::vector<EditTargets> edits() const {
    std::vector<EditTargets> targets;
    for (const int vertex : {testing::middle_vertex(mesh), mesh.vertex_count() / 3, 20}) {
      for (const double lift : {0.5, 1.0, 2.0}) {
        if (lift == 0.5 && !testing::is_night()) continue;
        targets.push_back(testing::pull(mesh, vertex, {0.0, 0.0, lift}));
        targets.push_back(testing::pull(mesh, vertex, {lift, 0.3 * lift, 0.0}));
      }
    }
    return targets;
  }

  Mesh mesh;
};

TEST_P(EditShape, IsKeptByEveryEdit) {
  HandleEditSolver solver(mesh, {});
  for (const EditTargets& targets : edits()) {
    const HandleEditResult result = solver.solve(targets);
    EXPECT_EQ(spoilt_panels(mesh, result), 0);
    EXPECT_LE(result.report.planarity_after, testing::kPromise);
    if (result.report.status == SolveStatus::kConverged) {
      EXPECT_GE(least_share(mesh, apply(mesh, result)), 0.05);
    }
  }
}

/// Where the bound is what stops the edit: points at rest follow ε, and once took a corner past it.
TEST(EditShapeAtItsBound, NoCornerOfAConvergedEditIsBeyondIt) {
  const auto bytes = testing::shared_mesh_bytes("pq_wein99_diag.obj");
  if (!bytes) GTEST_SKIP() << "skipped: no shared meshes";
  Mesh mesh = std::get<MeshFile>(read_obj(*bytes)).mesh;
  mesh.positions = testing::apply(mesh, planarise(mesh, {}));
  HandleEditSolver solver(mesh, {});
  const Eigen::Vector3d move(0.07447958750353563, -0.18140149348411755, 1.09819728794436);
  for (const double times : {1.0, 1.875}) {
    const HandleEditResult result = solver.solve(testing::pull(mesh, 662, times * move));
    EXPECT_EQ(result.report.status, SolveStatus::kConverged);
    const double share = least_share(mesh, apply(mesh, result));
    EXPECT_GE(share, 0.05);
    EXPECT_LE(share, 0.06);
  }
}

TEST_P(EditShape, IsKeptByHardHandles) {
  HandleEditOptions options;
  options.hard_handles = true;
  HandleEditSolver solver(mesh, options);
  for (const EditTargets& targets : edits()) {
    const HandleEditResult result = solver.solve(targets);
    EXPECT_EQ(spoilt_panels(mesh, result), 0);
    if (result.report.status != SolveStatus::kInfeasibleHandles) {
      EXPECT_EQ(result.report.handle_error, 0.0);
    }
  }
}

TEST_P(EditShape, IsKeptByTheReferenceEngine) {
  HandleEditOptions options;
  options.engine = Engine::kAugmentedLagrangian;
  HandleEditSolver solver(mesh, options);
  for (const double lift : {1.0, 2.0}) {
    if (lift == 1.0 && !testing::is_night()) continue;
    const auto targets = testing::pull(mesh, testing::middle_vertex(mesh), {0.0, 0.0, lift});
    EXPECT_EQ(spoilt_panels(mesh, solver.solve(targets)), 0);
  }
}

TEST_P(EditShape, IsKeptByEveryFrameOfADrag) {
  constexpr int kFrames = 40;
  constexpr double kBudget = 10.0;  // seconds: time must not decide
  HandleEditSolver solver(mesh, {});
  for (int frame = 1; frame <= kFrames; ++frame) {
    const double share = 2.0 * frame / kFrames;
    const EditTargets targets =
        testing::pull(mesh, testing::middle_vertex(mesh), {0.3 * share, 0.0, share});
    EXPECT_EQ(spoilt_panels(mesh, solver.drag(targets, kBudget)), 0) << "frame " << frame;
  }
}

/// The bound is what keeps it: without it the same edits spoil panels on at least one sample.
TEST(EditShapeOff, SpoilsPanels) {
  HandleEditOptions options;
  options.keep_shape = false;
  const Mesh mesh = testing::sample("vault", 16);
  const HandleEditResult result = solve_handle_edit(
      mesh, testing::pull(mesh, testing::middle_vertex(mesh), {0.0, 0.0, 2.0}), options);
  EXPECT_GT(spoilt_panels(mesh, result), 0);
}

INSTANTIATE_TEST_SUITE_P(Samples, EditShape,
                         ::testing::Values("roof", "vault", "dome", "freeform", "hex", "trihex"),
                         [](const auto& each) { return std::string(each.param); });

/// Bow-tie hexagons, as flat panels have them where a surface bends both ways; flat here, so that
/// they can be pulled together in their plane.
Mesh bow_ties(int columns, int rows) {
  constexpr double kWaist = 0.2;  // of a row, that points on even places are below it
  std::vector<Eigen::Vector3d> points;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      points.emplace_back(i, j + ((i + j) % 2 == 0 ? -kWaist : kWaist), 0.0);
    }
  }
  std::vector<std::vector<int>> faces;
  for (int j = 0; j < rows; ++j) {
    for (int i = j % 2; i + 2 < columns; i += 2) {
      const int low = j * columns + i, high = low + columns;
      faces.push_back({low, low + 1, low + 2, high + 2, high + 1, high});
    }
  }
  return testing::make_mesh(points, faces);
}

/// A waist that is pulled together stops before its corners go through the sides; the edit is
/// certified, at the first attempt.
TEST(EditShapeOfBowTies, IsKeptAndCertified) {
  const Mesh mesh = bow_ties(15, 12);
  HandleEditOptions options;
  options.reach = 4;
  options.softness = 5.0;
  int edits = 0;
  for (const int vertex : {6 * 15 + 6, 6 * 15 + 7, 5 * 15 + 8}) {
    for (const Eigen::Vector3d& move :
         {Eigen::Vector3d(0.0, 1.2, 0.0), Eigen::Vector3d(0.0, -1.2, 0.0),
          Eigen::Vector3d(0.5, 0.9, 0.0), Eigen::Vector3d(-0.5, -0.9, 0.0)}) {
      SCOPED_TRACE(vertex);
      const HandleEditResult result =
          solve_handle_edit(mesh, testing::pull(mesh, vertex, move), options);
      EXPECT_EQ(spoilt_panels(mesh, result), 0);
      EXPECT_EQ(result.report.status, SolveStatus::kConverged);
      EXPECT_GT(result.report.max_displacement, 0.4);
      EXPECT_LT(result.report.cost.factorizations, 150);
      ++edits;
    }
  }
  EXPECT_EQ(edits, 12);
}

}  // namespace
}  // namespace planish
