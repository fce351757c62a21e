// SPDX-License-Identifier: MIT
/// What "converged" means: a first-order point of the stated problem, support included. [OPT-1]
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engines/optimality.hpp"
#include "engines/patch_system.hpp"
#include "engines/working_set_newton.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/numeric/index.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

struct Case {
  const char* sample;
  double lift;
  bool keep_shape;
};

class EditOptimality : public ::testing::TestWithParam<Case> {
 protected:
  EditOptimality() : mesh(testing::sample(GetParam().sample, 20)) {
    options.keep_shape = GetParam().keep_shape;
    targets = testing::pull(mesh, testing::middle_vertex(mesh), {0.0, 0.0, GetParam().lift});
  }
  Mesh mesh;
  HandleEditOptions options;
  EditTargets targets;
};

TEST_P(EditOptimality, ConvergedMeansCertified) {
  const SolveReport report = solve_handle_edit(mesh, targets, options).report;
  ASSERT_TRUE(report.optimality);
  EXPECT_EQ(report.status == SolveStatus::kConverged, report.optimality->met());
  EXPECT_GE(report.optimality->certified_vertices, report.moved_vertices);
}

/// Descent with every vertex of the mesh free finds nothing below a certified result.
TEST_P(EditOptimality, NothingLowerIsNearWithTheWholeMeshFree) {
  const SolveReport report = solve_handle_edit(mesh, targets, options).report;
  if (report.status != SolveStatus::kConverged) GTEST_SKIP() << "not certified";
  testing::ProblemOnMesh on_mesh(mesh);
  for (VertexTerm& term : on_mesh.problem.terms) term.norm_weight = options.locality;
  on_mesh.problem.fairness_weight = options.smoothness;
  on_mesh.problem.shape_weight = options.keep_shape ? 1e-2 : 0.0;
  const Handle& handle = targets.handles.front();
  on_mesh.add_handle(handle.vertex,
                     (handle.target - mesh.positions.col(handle.vertex)) / on_mesh.model.unit());
  WorkingSetNewton newton(on_mesh.model);
  DisplacementField field(on_mesh.model.vertex_count(),
                          static_cast<int>(on_mesh.model.equations.size()));
  const HandleEditResult result = solve_handle_edit(mesh, targets, options);
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    const Eigen::Vector3d moved = result.moved_positions.col(static_cast<Eigen::Index>(k)) -
                                  mesh.positions.col(result.moved[k]);
    field.set_displacement(result.moved[k], moved / on_mesh.model.unit());
  }
  std::vector<int> everything(at(mesh.vertex_count()));
  std::iota(everything.begin(), everything.end(), 0);
  newton.set_support(everything);
  const double lowered = newton.settle(on_mesh.problem, {}, field, {}).objective;
  Patch patch = on_mesh.cut_all();
  for (int k = 0; k < patch.local_count(); ++k) {
    const auto found =
        std::lower_bound(result.moved.begin(), result.moved.end(), patch.vertices[at(k)]);
    if (found == result.moved.end() || *found != patch.vertices[at(k)]) continue;
    patch.displacement.col(k) =
        (result.moved_positions.col(found - result.moved.begin()) - mesh.positions.col(*found)) /
        on_mesh.model.unit();
  }
  PatchSystem system;
  system.attach(patch);
  EXPECT_GE(lowered, system.lagrangian().energy(patch.displacement, 0.0) * (1.0 - 1e-8));
}

INSTANTIATE_TEST_SUITE_P(Edits, EditOptimality,
                         ::testing::Values(Case{"vault", 0.75, true}, Case{"vault", 0.75, false},
                                           Case{"dome", 1.5, true}, Case{"dome", 1.5, false},
                                           Case{"freeform", 0.5, true}, Case{"hex", 0.3, true},
                                           Case{"trihex", 0.5, true}, Case{"trihex", 0.5, false}),
                         [](const auto& each) {
                           return std::string(each.param.sample) +
                                  (each.param.keep_shape ? "Bounded" : "Free") +
                                  std::to_string(each.index);
                         });

/// The published scenes and the edit that was 9.5 % above its valley's lowest point.
TEST(EditOptimalityOf, ThePublicScenesIsCertifiedAndLow) {
  HandleEditOptions options;
  options.keep_shape = false;
  const Mesh vault = testing::sample("vault", 32);
  const SolveReport on_vault =
      solve_handle_edit(vault, testing::public_scene_targets(vault), options).report;
  EXPECT_EQ(on_vault.status, SolveStatus::kConverged);
  EXPECT_LE(on_vault.objective.total(), 23.4220);
  const Mesh dome = testing::sample("dome", 32);
  const SolveReport on_dome =
      solve_handle_edit(dome, testing::public_scene_targets(dome), options).report;
  EXPECT_EQ(on_dome.status, SolveStatus::kConverged);
  EXPECT_LE(on_dome.objective.total(), 5.9897);
  const SolveReport outwards =
      solve_handle_edit(dome, testing::pull(dome, 751, {-0.01348194, 0.41779521, 0.06091765}),
                        options)
          .report;
  EXPECT_EQ(outwards.status, SolveStatus::kConverged);
  EXPECT_LE(outwards.objective.total(), 6.56);
}

/// Who limits the steps gets what there is after them, and no certificate.
TEST(EditOptimalityOf, AnEditWithALimitOfStepsIsNotSettled) {
  const Mesh mesh = testing::sample("vault", 20);
  const EditTargets targets = testing::pull(mesh, testing::middle_vertex(mesh), {0.0, 0.0, 0.5});
  const SolveReport limited = solve_handle_edit(mesh, targets, {.max_iterations = 5}).report;
  const SolveReport whole = solve_handle_edit(mesh, targets).report;
  EXPECT_EQ(limited.status, SolveStatus::kIterationLimit);
  EXPECT_FALSE(limited.optimality);
  EXPECT_LT(limited.cost.steps, whole.cost.steps / 2);
}

/// A state that is not a minimum has no certificate: the measure can fail.
TEST(OptimalityOf, AWorseStateIsNotMet) {
  testing::ProblemOnMesh on_mesh(testing::sample("dome", 8));
  on_mesh.add_handle(27, {0.0, 0.0, 0.5});
  const Patch patch = on_mesh.cut_all();
  PatchSystem system;
  system.attach(patch);
  PatchState state;
  state.displacement.setZero(3, patch.free_count);
  state.norm_dual.setZero(3, patch.free_count);
  state.multipliers.setZero(static_cast<Eigen::Index>(patch.equations.size()));
  Eigen::Matrix3Xd pulls;
  system.lagrangian().gradient_at(state, 1e300, pulls);
  const Optimality optimality = optimality_of(patch, state.displacement, pulls, 0.0);
  EXPECT_FALSE(optimality.met());
  EXPECT_NEAR(optimality.stationarity * 0.5, 500.0, 1e-9);  // the handle's pull, q · ‖target‖
}

/// On fine meshes what moves runs along lines through dozens of panels. [OPT-2]
class EditOfAFineMesh : public ::testing::TestWithParam<const char*> {};

TEST_P(EditOfAFineMesh, IsCertifiedThoughItsLinesRunOn) {
  const Mesh mesh = testing::sample(GetParam(), 100);
  const auto pulled = testing::pull(mesh, testing::middle_vertex(mesh), {0.0, 0.0, 0.5});
  const SolveReport report = solve_handle_edit(mesh, pulled, HandleEditOptions{}).report;
  EXPECT_EQ(report.status, SolveStatus::kConverged);
  EXPECT_LE(report.cost.factorizations, 500);
}

INSTANTIATE_TEST_SUITE_P(Samples, EditOfAFineMesh, ::testing::Values("vault", "dome", "freeform"));

}  // namespace
}  // namespace planish
