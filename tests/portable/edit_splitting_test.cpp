// SPDX-License-Identifier: MIT
#include "engines/edit_splitting.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engines/augmented_lagrangian.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::ProblemOnMesh;

/// A mesh without constraints and fairness: then (17) reads d = y, and one alternating step from d
/// is the proximal map (14) of d.
class ShrinkingSteps : public ::testing::TestWithParam<unsigned> {
 protected:
  ShrinkingSteps() : on_mesh(testing::triangle_grid(8, 8)) {
    on_mesh.problem.fairness_weight = 0.0;
  }

  [[nodiscard]] Eigen::Matrix3Xd step(const Eigen::Matrix3Xd& from, double penalty) {
    Patch patch = on_mesh.cut_all();
    patch.displacement = from;
    EditSplitting splitting(patch);
    EXPECT_TRUE(splitting.set_penalty(penalty));
    splitting.update_auxiliaries();
    splitting.update_primal();
    return patch.displacement;
  }

  ProblemOnMesh on_mesh;
};

/// (14), column by column.
TEST_P(ShrinkingSteps, AreTheClosedForm) {
  const Eigen::Matrix3Xd d = testing::random_points(GetParam(), 64);
  const double penalty = 0.4, threshold = 1.0 / (2 * penalty);
  const Eigen::Matrix3Xd shrunk = step(d, penalty);
  int zeros = 0;
  for (int v = 0; v < 64; ++v) {
    const double length = d.col(v).norm();
    const Eigen::Vector3d expected = std::max(0.0, 1.0 - threshold / length) * d.col(v);
    EXPECT_LT((shrunk.col(v) - expected).norm(), 1e-13);
    if (length <= threshold) {
      ++zeros;
      EXPECT_TRUE(shrunk.col(v).isZero(0.0)) << "exactly zero, not nearly";
    }
  }
  EXPECT_GT(zeros, 3);
  EXPECT_LT(zeros, 61);
}

/// The proximal map P of a convex function obeys, for all a and b, ‖Pa − Pb‖² ≤ ⟨Pa − Pb, a − b⟩.
TEST_P(ShrinkingSteps, AreFirmlyNonexpansive) {
  const Eigen::Matrix3Xd a = testing::random_points(GetParam(), 64);
  const Eigen::Matrix3Xd b = testing::random_points(GetParam() + 1000, 64);
  for (const double penalty : {0.2, 1.0, 10.0}) {
    const Eigen::Matrix3Xd gap = step(a, penalty) - step(b, penalty);
    EXPECT_LE(gap.squaredNorm(), gap.cwiseProduct(a - b).sum() + 1e-12);
  }
}

/// (13).
TEST_P(ShrinkingSteps, BlendAHandleWithItsTarget) {
  const Eigen::Vector3d target(1, -2, 3);
  on_mesh.add_handle(27, target, 50.0);
  const Eigen::Matrix3Xd d = testing::random_points(GetParam(), 64);
  const Eigen::Vector3d expected = (50.0 * target + 4.0 * d.col(27)) / 54.0;
  EXPECT_LT((step(d, 4.0).col(27) - expected).norm(), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ShrinkingSteps, ::testing::ValuesIn(testing::seeds()));

class Splitting : public ::testing::TestWithParam<const char*> {
 protected:
  Splitting() : on_mesh(testing::sample(GetParam(), 8)) {
    const int middle = testing::middle_vertex(on_mesh.model.mesh);
    on_mesh.add_handle(middle, {0, 0, 0.3});
    patch = on_mesh.cut_all();
  }
  ProblemOnMesh on_mesh;
  Patch patch;
};

/// Alternating minimisation lowers the augmented Lagrangian; with λ = 0 and d the minimiser for x,
/// the state where nothing moves is the fixed point of a problem without handles.
TEST_P(Splitting, StaysAtTheBaseMeshWithoutHandles) {
  ProblemOnMesh still(testing::sample(GetParam(), 8));
  Patch whole = still.cut_all();
  EditSplitting splitting(whole);
  const EngineOutcome run = run_alm(splitting, {}, {});
  EXPECT_EQ(run.status, SolveStatus::kConverged);
  EXPECT_EQ(run.records.size(), 1U);
  EXPECT_LT(whole.displacement.norm(), 1e-9);
  EXPECT_TRUE(splitting.support().empty());
}

/// [ALM-3]: a dual residual of zero means that d has stopped.
TEST_P(Splitting, DualResidualFallsWithinAPrimalUpdate) {
  EditSplitting splitting(patch);
  ASSERT_TRUE(splitting.set_penalty(10.0));
  splitting.update_auxiliaries();
  splitting.update_primal();
  const double first = splitting.dual_residual();
  for (int k = 0; k < 300; ++k) {
    splitting.update_auxiliaries();
    splitting.update_primal();
  }
  EXPECT_GT(first, 0.0);
  EXPECT_LT(splitting.dual_residual(), 1e-3 * first);
}

/// [ALM-2]: a factor per penalty, made once (Sec. 3.5).
TEST_P(Splitting, FactorsEachPenaltyOnce) {
  EditSplitting splitting(patch);
  for (const double penalty : {1.0, 2.0, 1.0, 2.0, 4.0, 1.0}) {
    ASSERT_TRUE(splitting.set_penalty(penalty));
  }
  EXPECT_EQ(splitting.factorizations(), 3);
}

/// [ALM-5] and [ALM-6]: at convergence ‖h‖ is small, and the support comes from y, so it is small
/// as well although every d is nonzero.
TEST_P(Splitting, ConvergesToASparseFlatState) {
  EditSplitting splitting(patch);
  const AlmOptions options{.max_inner = 30};
  const EngineOutcome run = run_alm(splitting, options, {});
  EXPECT_EQ(run.status, SolveStatus::kConverged);
  EXPECT_LE(run.records.back().primal_residual, options.primal_tolerance);
  EXPECT_LE(run.records.back().dual_residual, options.dual_tolerance);
  Eigen::VectorXd c;
  residuals_at(patch, patch.displacement, c);
  EXPECT_LT(c.lpNorm<Eigen::Infinity>(), 1e-3);
  EXPECT_GT(splitting.support().size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Splitting, ::testing::Values("vault", "dome", "hex", "trihex"));

/// A splitting that does nothing but report scripted residuals: what is tested is the loop.
struct ScriptedSplitting {
  std::vector<AlmResiduals> script;
  std::vector<double> penalties{};
  std::size_t outer = 0;
  int inner = 0, auxiliaries = 0;
  bool singular = false;

  bool set_penalty(double penalty) {
    penalties.push_back(penalty);
    return !singular;
  }
  void update_auxiliaries() { ++auxiliaries; }
  void update_primal() { ++inner; }
  [[nodiscard]] double dual_residual() const {
    return script[std::min(outer, script.size() - 1)].dual;
  }
  double update_multipliers() { return script[std::min(outer++, script.size() - 1)].primal; }
  [[nodiscard]] static double objective() { return 1.0; }
};

TEST(RunAlm, StopsWhenBothResidualsAreSmall) {
  ScriptedSplitting splitting{.script = {{1e-2, 1e-2}, {1e-6, 1e-2}, {1e-6, 1e-5}}};
  const EngineOutcome run = run_alm(splitting, {.max_inner = 4}, {});
  EXPECT_EQ(run.status, SolveStatus::kConverged);
  EXPECT_EQ(run.records.size(), 3u);
  EXPECT_EQ(splitting.inner, 4 + 4 + 1) << "l_max, or to the dual threshold";
  EXPECT_EQ(splitting.inner, splitting.auxiliaries);
  EXPECT_EQ(run.cost.steps, splitting.inner);
}

/// Sec. 3.3: μ grows only when ‖h‖ falls too slowly against ‖r̂‖.
TEST(RunAlm, RaisesThePenaltyOnlyWhereThePrimalResidualLags) {
  ScriptedSplitting lagging{.script = {{1.0, 1.0}, {0.9, 0.1}, {0.8, 0.01}}};
  (void)run_alm(lagging, {.penalty_growth = 2.0, .max_outer = 3}, {});
  EXPECT_EQ(lagging.penalties, (std::vector<double>{10.0, 20.0, 40.0}));
  ScriptedSplitting leading{.script = {{1.0, 1.0}, {0.1, 0.9}, {0.01, 0.8}}};
  (void)run_alm(leading, {.max_outer = 3}, {});
  EXPECT_EQ(leading.penalties, (std::vector<double>{10.0}));
}

TEST(RunAlm, NeverRaisesThePenaltyPastItsBound) {
  ScriptedSplitting splitting;
  double dual = 1.0;
  for (int k = 0; k < 50; ++k) splitting.script.push_back({1.0, dual *= 0.9});
  (void)run_alm(splitting, {.penalty_growth = 2.0, .largest_penalty = 100.0, .max_outer = 50}, {});
  EXPECT_EQ(splitting.penalties, (std::vector<double>{10.0, 20.0, 40.0, 80.0}));
}

TEST(RunAlm, ReportsHowItEnded) {
  ScriptedSplitting forever{.script = {{1.0, 1.0}}};
  EXPECT_EQ(run_alm(forever, {.max_outer = 5}, {}).status, SolveStatus::kIterationLimit);
  ScriptedSplitting none{.script = {{1.0, 1.0}}};
  EXPECT_TRUE(run_alm(none, {.max_outer = 0}, {}).records.empty());
  EXPECT_EQ(none.inner, 0);
  ScriptedSplitting broken{.script = {{std::nan(""), 1.0}}};
  EXPECT_EQ(run_alm(broken, {}, {}).status, SolveStatus::kNonFinite);
  ScriptedSplitting singular{.script = {{1.0, 1.0}}, .singular = true};
  EXPECT_EQ(run_alm(singular, {}, {}).status, SolveStatus::kSingularSystem);
  ScriptedSplitting stopped{.script = {{1.0, 1.0}}};
  int calls = 0;
  const EngineOutcome run = run_alm(stopped, {}, [&](const IterationRecord&) {
    return ++calls == 3 ? Flow::kStop : Flow::kContinue;
  });
  EXPECT_EQ(run.status, SolveStatus::kCancelled);
  EXPECT_EQ(run.records.size(), 3u);
}

}  // namespace
}  // namespace planish
