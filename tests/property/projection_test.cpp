// SPDX-License-Identifier: MIT
/// Problem (8): the nearest flat mesh.
#include "planish/projection/projection.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "planish/measures/metrics.hpp"
#include "support/mesh_builders.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

Positions moved_positions(const Mesh& mesh, const ProjectionResult& result) {
  Positions positions = mesh.positions;
  for (std::size_t k = 0; k < result.moved.size(); ++k) {
    positions.col(result.moved[k]) = result.moved_positions.col(static_cast<Eigen::Index>(k));
  }
  return positions;
}

class ProjectionOf : public ::testing::TestWithParam<const char*> {
 protected:
  ProjectionOf() : flat(testing::sample(GetParam(), 14)), bent(flat) {
    bent.positions += 0.03 * testing::random_points(3, flat.vertex_count());
  }
  Mesh flat, bent;
};

TEST_P(ProjectionOf, AFlatMeshIsItself) {
  const ProjectionResult result = project_to_planar(flat);
  EXPECT_TRUE(result.moved.empty());
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
  EXPECT_TRUE(project_to_planar(flat, flat.positions).moved.empty());
}

TEST_P(ProjectionOf, ABentMeshIsFlatAndNear) {
  for (const double fairness : {0.0, 0.1}) {
    SCOPED_TRACE(fairness);
    const ProjectionResult result = project_to_planar(bent, {.fairness_weight = fairness});
    const Positions after = moved_positions(bent, result);
    EXPECT_TRUE(result.report.usable()) << status_name(result.report.status);
    EXPECT_LE(planarity_summary(bent, after).max, testing::kPromise);
    EXPECT_TRUE(result.failing_faces.empty());
    const double rms =
        (after - bent.positions).norm() / std::sqrt(static_cast<double>(bent.vertex_count()));
    EXPECT_NEAR(result.rms_move, rms, 1e-12);
    EXPECT_LT(rms, 0.08) << "the noise itself is 0.05";
  }
}

TEST_P(ProjectionOf, IsIdempotent) {
  Mesh once = bent;
  once.positions = moved_positions(bent, project_to_planar(bent));
  const ProjectionResult again = project_to_planar(once);
  EXPECT_TRUE(testing::same_bits(moved_positions(once, again), once.positions));
}

/// With the distance alone: no flat mesh that we know of is nearer.
TEST_P(ProjectionOf, IsNotFartherThanTheFlatMeshItCameFrom) {
  const ProjectionResult result = project_to_planar(bent, {.fairness_weight = 0.0});
  const double moved = (moved_positions(bent, result) - bent.positions).norm();
  EXPECT_LE(moved, (flat.positions - bent.positions).norm());
}

/// At the nearest point the displacement is normal to the manifold: t = Jᵀλ, so it is orthogonal
/// to every tangent vector, for example a rigid motion. [PRO-4]
TEST_P(ProjectionOf, TheNearestPointIsReachedAtARightAngle) {
  const ProjectionResult result = project_to_planar(bent, {.fairness_weight = 0.0});
  const Positions after = moved_positions(bent, result);
  const Positions t = after - bent.positions;
  const Eigen::Vector3d mean = t.rowwise().mean();
  EXPECT_LT(mean.norm(), 1e-4 * t.norm());
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  const Eigen::Vector3d centre = after.rowwise().mean();
  double arms = 0.0;
  for (Eigen::Index v = 0; v < t.cols(); ++v) {
    const Eigen::Vector3d arm = after.col(v) - centre;
    torque += arm.cross(Eigen::Vector3d(t.col(v)));
    arms += arm.squaredNorm();
  }
  EXPECT_LT(torque.norm(), 1e-3 * t.norm() * std::sqrt(arms));
}

TEST_P(ProjectionOf, PinsStay) {
  const std::vector<int> pins{0, bent.vertex_count() / 2, bent.vertex_count() - 1};
  const ProjectionResult result = project_to_planar(bent, {}, pins);
  const Positions after = moved_positions(bent, result);
  EXPECT_LE(planarity_summary(bent, after).max, testing::kPromise);
  for (const int pin : pins) EXPECT_EQ(after.col(pin), bent.positions.col(pin));
}

/// [PRO-3]: a mesh that is bent in one place is mended in that place.
TEST_P(ProjectionOf, AHistoryKeepsTheRepairLocal) {
  Mesh dented = flat;
  const int middle = testing::middle_vertex(flat);
  dented.positions(2, middle) += 0.2;
  const ProjectionResult local = project_to_planar(dented, flat.positions);
  const ProjectionResult global = project_to_planar(dented);
  EXPECT_LE(planarity_summary(dented, moved_positions(dented, local)).max, testing::kPromise);
  EXPECT_LT(local.moved.size(), global.moved.size());
  EXPECT_LT(local.moved.size(), static_cast<std::size_t>(flat.vertex_count()) / 2);
}

/// A mesh with a few points off, as sliders leave it.
Mesh dent(const Mesh& flat) {
  Mesh dented = flat;
  for (const int v : {0, 1, 2}) {
    dented.positions(2, testing::middle_vertex(flat) + v) += 0.05 * (v + 1);
  }
  return dented;
}

/// [PRO-3] as it is written, to a first-order point.
TEST_P(ProjectionOf, AHistorysRepairIsCertified) {
  const Mesh dented = dent(flat);
  const ProjectionResult result = project_to_planar(dented, flat.positions, {.keep_shape = false});
  EXPECT_EQ(result.report.status, SolveStatus::kConverged);
  EXPECT_EQ(result.confined_because, ConfinedBecause::kNothing);
  ASSERT_TRUE(result.report.optimality);
  EXPECT_LE(result.report.optimality->stationarity, 1e-4);
  EXPECT_LE(result.report.optimality->outside, 1e-4);
}

/// Σ w_i ‖t_i‖ of [PRO-3], written down again.
double weighted_distance(const Mesh& given, const Positions& history, const Positions& after) {
  const Eigen::RowVectorXd moved = (given.positions - history).colwise().norm();
  const double soft = 0.05 * moved.maxCoeff();
  double sum = 0.0;
  for (int v = 0; v < given.vertex_count(); ++v) {
    sum += soft / (soft + moved[v]) * (after.col(v) - given.positions.col(v)).norm();
  }
  return sum;
}

/// Flat meshes around the repair, found by another engine: the repair, shaken, made flat again.
TEST_P(ProjectionOf, NothingNearTheRepairIsNearer) {
  const Mesh dented = dent(flat);
  const Positions repaired =
      moved_positions(dented, project_to_planar(dented, flat.positions, {.keep_shape = false}));
  const double reached = weighted_distance(dented, flat.positions, repaired);
  for (unsigned seed = 0; seed < 4; ++seed) {
    Mesh shaken = dented;
    shaken.positions = repaired + 1e-4 * testing::random_points(seed, dented.vertex_count());
    ProjectionOptions nearest;
    nearest.keep_shape = false;
    const Positions near = moved_positions(shaken, project_to_planar(shaken, nearest));
    EXPECT_GE(weighted_distance(dented, flat.positions, near), reached);
  }
}

/// [PRO-1] of a repair with a history, by its effect.
TEST_P(ProjectionOf, AHistorysRepairIsFairerWithItsWeight) {
  const Mesh dented = dent(flat);
  const FairnessOperator e =
      fairness_operator(dented, build_adjacency(dented), FairnessKind::kSecondDifference);
  const auto bending = [&](double weight) {
    const Positions after = moved_positions(
        dented, project_to_planar(dented, flat.positions,
                                  {.fairness_weight = weight, .keep_shape = false}));
    return (e * (after - dented.positions).transpose()).squaredNorm();
  };
  const double some = bending(10.0);
  EXPECT_LT(some, bending(0.0));
  EXPECT_LT(bending(1000.0), some);
}

/// [OPT-3]
TEST_P(ProjectionOf, ConvergedMeansCertified) {
  for (const double fairness : {0.0, 10.0}) {
    const ProjectionResult result = project_to_planar(bent, {.fairness_weight = fairness});
    if (result.report.status != SolveStatus::kConverged) continue;
    ASSERT_TRUE(result.report.optimality) << fairness;
    EXPECT_TRUE(result.report.optimality->met()) << fairness;
  }
}

TEST_P(ProjectionOf, AScaledAndMovedMeshIsTheScaledAndMovedProjection) {
  Mesh other = bent;
  other.positions *= 0.01;
  other.positions.colwise() += Eigen::Vector3d(3, -4, 5);
  const Positions here = moved_positions(bent, project_to_planar(bent));
  const Positions there = moved_positions(other, project_to_planar(other));
  const Positions expected = (0.01 * here).colwise() + Eigen::Vector3d(3, -4, 5);
  // Rounding is another far from the origin, and the nearest point is settled, not exact.
  EXPECT_LT((there - expected).colwise().norm().maxCoeff(), 1e-6 * mean_edge_length(other));
}

/// Both engines solve the same problem.
TEST_P(ProjectionOf, BothEnginesAgree) {
  const Positions newton = moved_positions(bent, project_to_planar(bent));
  const ProjectionResult reference =
      project_to_planar(bent, {.engine = Engine::kAugmentedLagrangian});
  const Positions alm = moved_positions(bent, reference);
  EXPECT_LE(planarity_summary(bent, alm).max, testing::kPromise);
  EXPECT_LT((newton - alm).norm(), 0.1 * (newton - bent.positions).norm());
}

INSTANTIATE_TEST_SUITE_P(Meshes, ProjectionOf, ::testing::Values("vault", "dome", "hex", "trihex"));

/// Everything pinned: nothing can be mended, and the report says which panels.
TEST(Projection, NamesTheFacesThatItCannotMend) {
  Mesh mesh = testing::quad_grid(4, 4);
  mesh.positions(2, 15) = 0.3;
  std::vector<int> all(16);
  for (int v = 0; v < 16; ++v) all[static_cast<std::size_t>(v)] = v;
  const ProjectionResult result = project_to_planar(mesh, {}, all);
  EXPECT_EQ(result.report.status, SolveStatus::kToleranceNotMet);
  EXPECT_EQ(result.failing_faces, std::vector<int>{8});
  EXPECT_TRUE(result.moved.empty());
}

TEST(ProjectionOptions, NameWhatIsWrong) {
  const auto problem = [](const ProjectionOptions& options) {
    return find_problem(options).value_or("");
  };
  EXPECT_EQ(problem({}), "");
  EXPECT_NE(problem({.fairness_weight = -1.0}).find("fairness_weight"), std::string::npos);
  EXPECT_NE(problem({.distance_weight = 0.0}).find("distance_weight"), std::string::npos);
  EXPECT_NE(problem({.tolerance = std::numeric_limits<double>::quiet_NaN()}).find("tolerance"),
            std::string::npos);
  EXPECT_NE(problem({.max_iterations = -1}).find("max_iterations"), std::string::npos);
}

}  // namespace
}  // namespace planish
