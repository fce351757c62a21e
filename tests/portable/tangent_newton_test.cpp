// SPDX-License-Identifier: MIT
#include "engines/tangent_newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "engines/fair_flat.hpp"
#include "engines/optimality.hpp"
#include "planish/problem/problem.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

/// A noisy translational grid and the whole of it as one patch, α_f = 10, with the shape bound.
class TangentNewtonOn : public ::testing::TestWithParam<double> {
 protected:
  TangentNewtonOn() : model(noisy_grid(GetParam()), FairnessKind::kSecondDifference) {
    problem.model = &model;
    problem.seeks_support = false;
    problem.fairness_weight = 20.0;
    problem.shape_weight = kShapeWeight;
    problem.terms.resize(static_cast<std::size_t>(model.vertex_count()));
    for (VertexTerm& term : problem.terms) term.square_weight = 2.0;
    std::vector<int> all(static_cast<std::size_t>(model.vertex_count()));
    std::iota(all.begin(), all.end(), 0);
    PatchCutter cutter(model);
    cutter.cut(problem, all, patch);
    displacement.setZero(3, patch.free_count);
  }

  static Mesh noisy_grid(double noise) {
    Mesh mesh = testing::quad_grid(18, 18, [](double x, double y) {
      return 2.0 * std::sin(0.2 * x) + 1.5 * std::sin(0.15 * y);
    });
    mesh.positions += noise * testing::random_points(11, mesh.vertex_count());
    return mesh;
  }

  MeshModel model;
  EditProblem problem;
  Patch patch;
  Eigen::Matrix3Xd displacement;
};

TEST_P(TangentNewtonOn, ReachesTheMinimumThatTheFactoredHessianReaches) {
  ASSERT_EQ(descend_along_flat(patch, {.settled = 1e-7}, {}, displacement).status,
            SolveStatus::kConverged);
  Eigen::Matrix3Xd factored = Eigen::Matrix3Xd::Zero(3, patch.free_count);
  ASSERT_EQ(find_fair_flat(patch, {.settled = 1e-8}, {}, factored).status, SolveStatus::kConverged);
  EXPECT_GT(displacement.norm(), 10.0 * GetParam());
  EXPECT_LT((displacement - factored).colwise().norm().maxCoeff(), 1e-6);
}

TEST_P(TangentNewtonOn, ConvergedMeansFlatAndCertified) {
  const EngineOutcome outcome = descend_along_flat(patch, {}, {}, displacement);
  ASSERT_EQ(outcome.status, SolveStatus::kConverged);
  Eigen::VectorXd residuals;
  residuals_at(patch, displacement, residuals);
  EXPECT_LT(residuals.cwiseAbs().maxCoeff(), 1e-9);
  const auto optimality = fitted_optimality(patch, displacement);
  ASSERT_TRUE(optimality.has_value());
  EXPECT_LE(optimality->stationarity, 1e-4);
}

TEST_P(TangentNewtonOn, NeverClimbsOnceItIsFlat) {
  const EngineOutcome outcome = descend_along_flat(patch, {}, {}, displacement);
  double last = HUGE_VAL;
  int flat = 0;
  for (const IterationRecord& record : outcome.records) {
    if (record.primal_residual > 1e-9) continue;
    EXPECT_LE(record.objective, last * (1.0 + 1e-12));
    last = record.objective;
    ++flat;
  }
  EXPECT_GT(flat, 1);
}

TEST_P(TangentNewtonOn, StopsWhenAsked) {
  int steps = 0;
  const EngineOutcome outcome = descend_along_flat(
      patch, {},
      [&](const IterationRecord&) { return ++steps == 2 ? Flow::kStop : Flow::kContinue; },
      displacement);
  EXPECT_EQ(outcome.status, SolveStatus::kCancelled);
  EXPECT_EQ(steps, 2);
}

INSTANTIATE_TEST_SUITE_P(Noise, TangentNewtonOn, ::testing::Values(0.005, 0.03));

}  // namespace
}  // namespace planish
