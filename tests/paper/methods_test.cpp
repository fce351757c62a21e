// SPDX-License-Identifier: MIT
/// The compared methods do what their papers say, as far as docs/paper.md claims it.
#include "planish/comparison/methods.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "planish/comparison/edit_measure.hpp"
#include "planish/comparison/global_subspace.hpp"
#include "support/scenes.hpp"

namespace planish::comparison {
namespace {

constexpr int kSide = 16;
constexpr int kHandle = 8 * kSide + 8;
constexpr double kFlat = 1e-6;  // mm/m

EditTask lifted(const char* name, double lift) {
  const Mesh mesh = testing::sample(name, kSide);
  return {.mesh = mesh, .targets = testing::pull(mesh, kHandle, {0, 0, lift}), .options = {}};
}

class MethodOn : public ::testing::TestWithParam<const char*> {};

TEST_P(MethodOn, OneRingMovesTheRingAlone) {
  const EditTask task = lifted(GetParam(), 0.5);
  const ComparedEdit edit = edit_one_ring(task);
  EXPECT_TRUE(edit.finished);
  const EditMeasure m = measure(task, edit.positions);
  EXPECT_LE(m.planarity, kFlat);
  EXPECT_EQ(m.handle_error, 0.0);
  const std::vector<int> ring = testing::ring_neighbourhood(task.mesh, kHandle, 1);
  for (int v = 0; v < task.mesh.vertex_count(); ++v) {
    if (std::binary_search(ring.begin(), ring.end(), v)) continue;
    EXPECT_EQ(edit.positions.col(v), task.mesh.positions.col(v)) << v;
  }
}

TEST_P(MethodOn, GreedyNeedsFewerVerticesThanTheSparseEdit) {
  const EditTask task = lifted(GetParam(), 0.2);
  const ComparedEdit edit = edit_greedily(task);
  ASSERT_TRUE(edit.finished);
  const EditMeasure m = measure(task, edit.positions);
  EXPECT_LE(m.planarity, kFlat);
  EXPECT_EQ(m.handle_error, 0.0);
  const EditMeasure ours =
      measure(task, apply(task.mesh, solve_handle_edit(task.mesh, task.targets)));
  EXPECT_LT(m.moved, ours.moved);
  EXPECT_GT(m.fairness, ours.fairness);
}

TEST_P(MethodOn, ShapeUpSpreadsTheEditAndLeavesPanelsBent) {
  const EditTask task = lifted(GetParam(), 0.5);
  const ComparedEdit edit = edit_by_shape_up(task);
  const EditMeasure m = measure(task, edit.positions);
  const EditMeasure ours =
      measure(task, apply(task.mesh, solve_handle_edit(task.mesh, task.targets)));
  EXPECT_GT(m.planarity, 1e3 * kFlat);  // a soft constraint
  EXPECT_LT(m.planarity, 100.0);
  EXPECT_GT(m.moved_visibly, ours.moved_visibly);
  EXPECT_LT(m.fairness, ours.fairness);
}

TEST_P(MethodOn, TangentSpaceEditIsGlobalAndFlatAfterReprojection) {
  const EditTask task = lifted(GetParam(), 0.5);
  const ComparedEdit edit = edit_in_tangent_space(task);
  ASSERT_TRUE(edit.finished);
  const EditMeasure m = measure(task, edit.positions);
  EXPECT_LE(m.planarity, kFlat);
  EXPECT_EQ(m.moved, (kSide - 2) * (kSide - 2));  // all but the boundary
}

TEST_P(MethodOn, NothingMovesWithoutAPull) {
  const EditTask task = lifted(GetParam(), 0.0);
  const double edge = mean_edge_length(task.mesh);
  for (const ComparedEdit& edit : {edit_one_ring(task), edit_greedily(task), edit_by_shape_up(task),
                                   edit_in_tangent_space(task)}) {
    EXPECT_LE((edit.positions - task.mesh.positions).cwiseAbs().maxCoeff(), 1e-9 * edge);
  }
}

TEST_P(MethodOn, YardstickAgreesWithTheProductsReport) {
  const EditTask task = lifted(GetParam(), 0.5);
  const HandleEditResult result = solve_handle_edit(task.mesh, task.targets);
  const EditMeasure m = measure(task, apply(task.mesh, result));
  EXPECT_NEAR(m.objective, result.report.objective.total(), 1e-6 * m.objective);
  EXPECT_NEAR(0.5 * m.fairness, result.report.objective.fairness, 1e-6 * m.objective);
  EXPECT_EQ(m.moved, result.report.moved_vertices);
  EXPECT_NEAR(m.handle_error, result.report.handle_error, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Scenes, MethodOn, ::testing::Values("vault", "dome"));

/// Eigenvectors, so: orthonormal, tangent, fairer than any other of the same span's complement.
TEST(GlobalSubspace, IsOrthonormalTangentAndFairestFirst) {
  const Mesh mesh = testing::sample("dome", kSide);
  const Eigen::MatrixXd basis = global_subspace(mesh, 4, FairnessKind::kSecondDifference);
  ASSERT_EQ(basis.cols(), 4);
  EXPECT_LE((basis.transpose() * basis - Eigen::MatrixXd::Identity(4, 4)).cwiseAbs().maxCoeff(),
            1e-9);
  const MeshModel model(mesh, FairnessKind::kSecondDifference);
  double before = 0.0;
  for (int k = 0; k < 4; ++k) {
    const Positions t = Eigen::Map<const Positions>(basis.col(k).data(), 3, mesh.vertex_count());
    for (const FlatnessEquation& equation : model.equations.of<PlanarPolygon>()) {
      FourPoints points, moves;
      for (int c = 0; c < 4; ++c) {
        points.col(c) = model.points.col(equation.vertices[static_cast<std::size_t>(c)]);
        moves.col(c) = t.col(equation.vertices[static_cast<std::size_t>(c)]);
      }
      EXPECT_NEAR(gradient(equation, points).cwiseProduct(moves).sum(), 0.0, 1e-6);
    }
    const double fairness = (model.fairness * t.transpose()).squaredNorm();
    EXPECT_GE(fairness, before);
    before = fairness;
  }
  const auto lengths =
      Eigen::Map<const Positions>(basis.col(0).data(), 3, mesh.vertex_count()).colwise().norm();
  EXPECT_GT((lengths.array() > 1e-3 * lengths.maxCoeff()).count(), 150);  // of 196: nothing local
}

}  // namespace
}  // namespace planish::comparison
