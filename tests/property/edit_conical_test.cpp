// SPDX-License-Identifier: MIT
/// Edits that keep vertices conical: what the constraint promises, measured without its code.
#include <gtest/gtest.h>

#include <variant>
#include <vector>

#include "planish/constraints/conical_star.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/measures/panel_health.hpp"
#include "planish/mesh/adjacency.hpp"
#include "planish/projection/projection.hpp"
#include "support/cones.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kConical = 1e-9;  ///< degrees

std::vector<int> star_of(const Mesh& mesh, int vertex) {
  const Adjacency adjacency = build_adjacency(mesh);
  const auto around = adjacency.neighbours[vertex];
  std::vector<int> star{vertex};
  star.insert(star.end(), around.begin(), around.end());
  return star;
}

std::vector<KeptConstraint> conical() { return {{"conical", kConical}}; }

void expect_conical(const Mesh& mesh, const HandleEditResult& result) {
  const Positions after = apply(mesh, result);
  EXPECT_LE(testing::worst_cone_defect(mesh, after), kConical);
  EXPECT_LE(planarity_summary(mesh, after).max_excess, testing::kPromise);
  for (int f = 0; f < mesh.face_count(); ++f) {
    EXPECT_EQ(panel_damage(mesh.positions, after, mesh.face(f)), PanelDamage::kNone) << f;
  }
  EXPECT_EQ(moved_vertex_count(mesh.positions, after), static_cast<int>(result.moved.size()));
}

TEST(EditConical, KeepsVerticesConicalOnTheDome) {
  const Mesh mesh = testing::sample("dome", 16);
  ASSERT_LT(testing::worst_cone_defect(mesh, mesh.positions), 1e-10);
  HandleEditOptions options;
  options.constraints = conical();
  const EditTargets targets = testing::pull(mesh, 8 * 16 + 8, {0.0, 0.0, 0.3});
  const HandleEditResult result = solve_handle_edit(mesh, targets, options);
  expect_conical(mesh, result);
  EXPECT_FALSE(result.moved.empty());
  EXPECT_EQ(result.report.violations.back().kind, "conical");
  EXPECT_LE(result.report.violations.back().after_max, kConical);
  EXPECT_GT(testing::worst_cone_defect(mesh, apply(mesh, solve_handle_edit(mesh, targets))), 0.1);
}

TEST(EditConical, AndCircularHoldTogether) {
  const Mesh mesh = testing::sample("dome", 16);
  HandleEditOptions options;
  options.constraints = {{"circular", 1e-9}, {"conical", kConical}};
  const HandleEditResult result =
      solve_handle_edit(mesh, testing::pull(mesh, 8 * 16 + 8, {0.0, 0.0, 0.3}), options);
  expect_conical(mesh, result);
  ASSERT_EQ(result.report.violations.size(), 3u);
  EXPECT_LE(result.report.violations[1].after_max, 1e-9);
}

/// Two engines that search in different ways agree on what the least edit is.
TEST(EditConical, TheReferenceEngineAgrees) {
  struct Case {
    int size;
    std::vector<KeptConstraint> kept;
  };
  const KeptConstraint circular{"circular", 1e-9};
  for (const Case& one :
       {Case{12, {circular}}, Case{12, conical()}, Case{8, {circular, conical().front()}}}) {
    SCOPED_TRACE(one.kept.back().kind);
    const Mesh mesh = testing::sample("dome", one.size);
    const int middle = (one.size / 2) * one.size + one.size / 2;
    const EditTargets targets = testing::pull(mesh, middle, {0.0, 0.0, 0.6});
    HandleEditOptions options;
    options.constraints = one.kept;
    const HandleEditResult newton = solve_handle_edit(mesh, targets, options);
    options.engine = Engine::kAugmentedLagrangian;
    const HandleEditResult reference = solve_handle_edit(mesh, targets, options);
    ASSERT_TRUE(reference.report.usable());
    for (const KindViolation& kind : reference.report.violations) {
      EXPECT_LE(kind.after_max, kind.kind == "planar" ? testing::kPromise : kConical);
    }
    EXPECT_GE(reference.report.objective.total(), (1.0 - 1e-6) * newton.report.objective.total());
    EXPECT_LE(reference.report.objective.total(), 1.02 * newton.report.objective.total());
  }
}

/// Around a vertex of any valence a mesh is made conical, and an edit beside it keeps it so.
TEST(EditConical, HoldsAtOtherValences) {
  for (const int valence : {5, 6, 7}) {
    SCOPED_TRACE(valence);
    Mesh mesh = testing::sectors(valence, 4);
    ProjectionOptions project;
    project.constraints = conical();
    const ProjectionResult exact = project_to_planar(mesh, project);
    ASSERT_TRUE(exact.report.usable()) << status_name(exact.report.status);
    mesh.positions(Eigen::all, exact.moved) = exact.moved_positions;
    ASSERT_LE(testing::axis_spread(mesh, mesh.positions, 0), 10.0 * kConical);
    ASSERT_LE(testing::worst_cone_defect(mesh, mesh.positions), kConical);
    ASSERT_LE(planarity_summary(mesh).max_excess, testing::kPromise);
    const EditTargets targets = testing::pull(mesh, mesh.face(0)[1], {0.0, 0.0, 0.2});
    HandleEditOptions options;
    options.constraints = conical();
    const HandleEditResult result = solve_handle_edit(mesh, targets, options);
    expect_conical(mesh, result);
    EXPECT_FALSE(result.moved.empty());
    EXPECT_LE(testing::axis_spread(mesh, apply(mesh, result), 0), 10.0 * kConical);
    const Positions flat = apply(mesh, solve_handle_edit(mesh, targets));
    EXPECT_GT(testing::axis_spread(mesh, flat, 0), 0.1);
    EXPECT_GT(star_defect(flat, star_of(mesh, 0)), 0.1);
  }
}

/// Issue 12: the public conical mesh made exactly so, then six edits of 7 × 7 points.
TEST(EditConical, TheSaddleIsMadeConicalAndStaysSo) {
  const auto bytes = testing::shared_mesh_bytes("pq_conical_saddle.obj");
  if (!bytes) GTEST_SKIP() << "skipped: no shared meshes";
  Mesh mesh = std::get<MeshFile>(read_mesh(*bytes, MeshFormat::kObj)).mesh;
  EXPECT_GT(testing::worst_cone_defect(mesh, mesh.positions), 0.01);
  ProjectionOptions project;
  project.constraints = conical();
  const ProjectionResult exact = project_to_planar(mesh, project);
  ASSERT_TRUE(exact.report.usable());
  for (std::size_t k = 0; k < exact.moved.size(); ++k) {
    mesh.positions.col(exact.moved[k]) = exact.moved_positions.col(static_cast<Eigen::Index>(k));
  }
  ASSERT_LE(testing::worst_cone_defect(mesh, mesh.positions), kConical);
  ASSERT_LE(planarity_summary(mesh).max_excess, testing::kPromise);
  EXPECT_LT(exact.max_move, 0.01);
  HandleEditOptions options;
  options.constraints = conical();
  options.reach = 3;
  HandleEditSolver solver(mesh, options);
  for (int k = 1; k <= 6; ++k) {
    const int vertex = k * mesh.vertex_count() / 7;
    const HandleEditResult result = solver.solve(testing::pull(mesh, vertex, {0.0, 0.0, 0.1}));
    expect_conical(mesh, result);
    EXPECT_TRUE(result.report.usable()) << vertex;
    EXPECT_GT(result.moved.size(), 25u);
    EXPECT_LE(result.moved.size(), 49u);
    EXPECT_LT(result.report.handle_error, 0.07);
  }
}

}  // namespace
}  // namespace planish
