// SPDX-License-Identifier: MIT
/// Meshes that no flat one is near become flat once a few panels are parted.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/projection/planarising.hpp"
#include "planish/splitting/split_until_flat.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

ProjectionOptions fair_options() {
  ProjectionOptions options;
  options.fairness_weight = Planarising{}.fairness_weight;
  return options;
}

HybridOptions at_most(int panels) {
  HybridOptions options;
  options.most_panels = panels;
  return options;
}

Positions positions_of(const HybridMesh& hybrid) {
  Positions positions = hybrid.cut.mesh.positions;
  for (std::size_t k = 0; k < hybrid.result.moved.size(); ++k) {
    positions.col(hybrid.result.moved[k]) =
        hybrid.result.moved_positions.col(static_cast<Eigen::Index>(k));
  }
  return positions;
}

/// How many panels of the mesh that was cut have more than one part.
int parted_panels(const HybridMesh& hybrid) {
  const int before =
      hybrid.cut.parents.empty()
          ? 0
          : *std::max_element(hybrid.cut.parents.begin(), hybrid.cut.parents.end()) + 1;
  const std::set<int> parted(hybrid.cut.parents.begin() + before, hybrid.cut.parents.end());
  return static_cast<int>(parted.size());
}

void expect_flat_and_sound(const HybridMesh& hybrid, const ProjectionOptions& options) {
  EXPECT_TRUE(hybrid.reached);
  EXPECT_TRUE(hybrid.result.failing_faces.empty());
  Mesh flat = hybrid.cut.mesh;
  flat.positions = positions_of(hybrid);
  EXPECT_LE(planarity_summary(flat).max_excess, options.tolerance);
  for (int f = 0; f < flat.face_count(); ++f) {
    EXPECT_EQ(panel_damage(hybrid.cut.mesh.positions, flat.positions, flat.face(f)),
              PanelDamage::kNone)
        << f;
  }
}

/// A hyperbolic paraboloid by its asymptotic lines: every quad between them is bent, and where the
/// boundary stays no flat mesh is near.
Mesh twisted_mesh(int size) {
  Mesh mesh;
  mesh.positions.resize(3, size * size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      const double x = i - 0.5 * (size - 1), y = j - 0.5 * (size - 1);
      mesh.positions.col(i * size + j) << x, y, 0.15 * x * y;
    }
  }
  for (int i = 0; i + 1 < size; ++i) {
    for (int j = 0; j + 1 < size; ++j) {
      const int v = i * size + j;
      mesh.face_vertices.insert(mesh.face_vertices.end(), {v, v + size, v + size + 1, v + 1});
      mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
    }
  }
  return mesh;
}

TEST(HybridMesh, OfATwistedMeshIsFlatWithAtMostHalfOfThePanelsSplit) {
  const Mesh mesh = twisted_mesh(7);
  const ProjectionOptions options = fair_options();
  const std::vector<int> rim = boundary_vertices(mesh);
  ASSERT_FALSE(project_to_planar(mesh, options, rim).failing_faces.empty());
  const HybridMesh hybrid = split_until_flat(mesh, options, rim, at_most(18));
  expect_flat_and_sound(hybrid, options);
  EXPECT_GT(hybrid.panels, 0);
  EXPECT_LE(hybrid.panels, 18);
  EXPECT_EQ(hybrid.panels, parted_panels(hybrid));
  EXPECT_TRUE(hybrid.cut.added.empty());
  for (const HybridStanding& standing : hybrid.curve) {
    EXPECT_TRUE(standing.failing_faces > 0 || standing.panels >= hybrid.panels);
  }
}

/// Halving tries numbers of panels that leave as many bent as fewer do: nobody reads those.
TEST(HybridMesh, HasACurveThatIsBetterWithEveryEntry) {
  const Mesh mesh = twisted_mesh(7);
  const HybridMesh hybrid =
      split_until_flat(mesh, fair_options(), boundary_vertices(mesh), at_most(18));
  ASSERT_GT(hybrid.curve.size(), 1U);
  EXPECT_LT(static_cast<int>(hybrid.curve.size()), hybrid.projections);
  EXPECT_EQ(hybrid.curve.front().panels, 0);
  for (std::size_t k = 1; k < hybrid.curve.size(); ++k) {
    const HybridStanding &before = hybrid.curve[k - 1], &after = hybrid.curve[k];
    EXPECT_GT(after.panels, before.panels);
    EXPECT_LE(after.failing_faces, before.failing_faces);
    if (after.failing_faces == before.failing_faces) {
      EXPECT_EQ(after.failing_faces, 0);
      EXPECT_LT(after.rms_move, before.rms_move);
    }
  }
  const auto taken = std::find_if(hybrid.curve.begin(), hybrid.curve.end(),
                                  [](const HybridStanding& one) { return one.failing_faces == 0; });
  ASSERT_NE(taken, hybrid.curve.end());
  EXPECT_EQ(taken->panels, hybrid.panels);
  EXPECT_EQ(taken->rms_move, hybrid.result.rms_move);
}

TEST(HybridMesh, IsTheProjectionOfTheCutMesh) {
  const Mesh mesh = twisted_mesh(6);
  const ProjectionOptions options = fair_options();
  const std::vector<int> rim = boundary_vertices(mesh);
  const HybridMesh hybrid = split_until_flat(mesh, options, rim, at_most(12));
  EXPECT_EQ(hybrid.cut.mesh.positions, mesh.positions);
  const ProjectionResult again = project_to_planar(hybrid.cut.mesh, options, rim);
  EXPECT_GT(hybrid.panels, 0);
  EXPECT_EQ(again.moved, hybrid.result.moved);
  EXPECT_EQ(again.moved_positions, hybrid.result.moved_positions);
  const Positions flat = positions_of(hybrid);
  for (const int v : rim) EXPECT_EQ(flat.col(v), mesh.positions.col(v)) << v;
}

TEST(HybridMesh, LeavesFlatMeshesAsTheyAre) {
  const Mesh mesh = testing::sample("vault", 8);
  const HybridMesh hybrid = split_until_flat(mesh, fair_options(), {}, at_most(5));
  EXPECT_TRUE(hybrid.reached);
  EXPECT_EQ(hybrid.panels, 0);
  EXPECT_TRUE(hybrid.result.moved.empty());
  EXPECT_EQ(hybrid.curve.size(), 1U);
  EXPECT_EQ(hybrid.projections, 1);
}

TEST(HybridMesh, GivesTheFewestBentPanelsWhereTooFewMayBeSplit) {
  const Mesh mesh = twisted_mesh(6);
  ProjectionOptions options = fair_options();
  options.within = 1e-3;
  const HybridMesh hybrid = split_until_flat(mesh, options, {}, at_most(2));
  EXPECT_FALSE(hybrid.reached);
  for (const HybridStanding& standing : hybrid.curve) {
    EXPECT_GE(standing.failing_faces, static_cast<int>(hybrid.result.failing_faces.size()));
  }
}

/// Where nothing may move the panels must be triangles.
TEST(HybridMesh, SplitsLargePanelsIntoTrianglesWhereHalvesAreNotEnough) {
  Mesh mesh;
  mesh.positions.resize(3, 6);
  mesh.positions << 2, 1, -1, -2, -1, 1, 0, 2, 2, 0, -2, -2, 0, 0.3, 0, 0.3, 0, 0.3;
  mesh.face_vertices = {0, 1, 2, 3, 4, 5};
  mesh.face_offsets = {0, 6};
  const ProjectionOptions options = fair_options();
  const HybridMesh hybrid = split_until_flat(mesh, options, {0, 1, 2, 3, 4, 5}, at_most(1));
  expect_flat_and_sound(hybrid, options);
  EXPECT_EQ(hybrid.panels, 1);
  EXPECT_EQ(hybrid.cut.mesh.face_count(), 4);
  EXPECT_TRUE(hybrid.result.moved.empty());
}

TEST(HybridMesh, NamesWhatIsWrong) {
  EXPECT_FALSE(find_problem(at_most(1)));
  EXPECT_TRUE(find_problem(at_most(0)));
  HybridOptions options = at_most(1);
  options.most_projections = 0;
  EXPECT_TRUE(find_problem(options));
}

}  // namespace
}  // namespace planish
