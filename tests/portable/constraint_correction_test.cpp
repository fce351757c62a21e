// SPDX-License-Identifier: MIT
#include "engines/constraint_correction.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::ProblemOnMesh;

/// J on the free vertices, rows in the order of the patch's equations.
Eigen::MatrixXd dense_jacobian(const Patch& patch, const Eigen::Matrix3Xd& displacement) {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(
      static_cast<Eigen::Index>(patch.equations.size()), 3 * patch.free_count);
  Patch moved = patch;
  moved.displacement.leftCols(patch.free_count) = displacement;
  patch.equations.for_each([&](int e, const auto& row) {
    const auto g = gradient(row, corners(moved, row));
    for (std::size_t k = 0; k < row.vertices.size(); ++k) {
      const int v = row.vertices[k];
      if (v < patch.free_count) {
        jacobian.block<1, 3>(e, 3 * v) = g.col(static_cast<Eigen::Index>(k)).transpose();
      }
    }
  });
  return jacobian;
}

class CorrectionOn : public ::testing::TestWithParam<std::tuple<const char*, unsigned>> {
 protected:
  CorrectionOn()
      : on_mesh(testing::sample(std::get<0>(GetParam()), 10)),
        patch(on_mesh.cut(testing::ring_neighbourhood(
            on_mesh.model.mesh, testing::middle_vertex(on_mesh.model.mesh), 2))),
        noise(0.02 * testing::random_points(std::get<1>(GetParam()), patch.free_count)) {}

  ProblemOnMesh on_mesh;
  Patch patch;
  Eigen::Matrix3Xd noise;
};

/// [COR-1]: the shortest δ with Jδ = −c, as a dense pseudo-inverse gives it.
TEST_P(CorrectionOn, StepIsTheShortestOntoTheLinearisedConstraints) {
  ConstraintCorrection correction;
  ASSERT_TRUE(correction.attach(patch));
  ASSERT_TRUE(correction.factorize(noise, 1e-10));
  Eigen::VectorXd c;
  residuals_at(patch, noise, c);
  Eigen::Matrix3Xd delta;
  correction.step(c, delta);
  const Eigen::MatrixXd jacobian = dense_jacobian(patch, noise);
  const Eigen::MatrixXd gram = jacobian * jacobian.transpose() +
                               1e-10 * Eigen::MatrixXd::Identity(jacobian.rows(), jacobian.rows());
  const Eigen::VectorXd expected = -jacobian.transpose() * gram.ldlt().solve(c);
  const Eigen::Map<const Eigen::VectorXd> flat(delta.data(), delta.size());
  EXPECT_LT((flat - expected).norm(), 1e-6 * expected.norm());
  Eigen::VectorXd image;
  correction.apply_jacobian(delta, image);
  EXPECT_LT((image - jacobian * flat).norm(), 1e-12);
  EXPECT_LT((image + c).norm(), 1e-5 * c.norm());
}

TEST_P(CorrectionOn, ReachesRounding) {
  Eigen::Matrix3Xd displacement = noise;
  int factorizations = 0;
  const double worst = correct_constraints(patch, 8, displacement, factorizations);
  EXPECT_LT(worst, 1e-12);
  Eigen::VectorXd c;
  residuals_at(patch, displacement, c);
  EXPECT_EQ(c.cwiseAbs().maxCoeff(), worst);
  EXPECT_LE(factorizations, 8);
  EXPECT_LT((displacement - noise).norm(), 3.0 * noise.norm()) << "a correction, not a leap";
}

TEST_P(CorrectionOn, LeavesAnExactStateAlone) {
  Eigen::Matrix3Xd displacement = noise;
  int factorizations = 0;
  (void)correct_constraints(patch, 8, displacement, factorizations);
  const Eigen::Matrix3Xd before = displacement;
  (void)correct_constraints(patch, 8, displacement, factorizations);
  EXPECT_LT((displacement - before).norm(), 1e-11);
}

TEST_P(CorrectionOn, NeverMovesTheHalo) {
  const Positions halo = patch.displacement;
  Eigen::Matrix3Xd displacement = noise;
  int factorizations = 0;
  (void)correct_constraints(patch, 8, displacement, factorizations);
  EXPECT_EQ(patch.displacement, halo);
  EXPECT_EQ(displacement.cols(), patch.free_count);
}

INSTANTIATE_TEST_SUITE_P(Meshes, CorrectionOn,
                         ::testing::Combine(::testing::Values("vault", "dome", "hex", "trihex"),
                                            ::testing::Values(1u, 2u, 3u)));

/// A fan of many quads around one vertex: J Jᵀ would be dense there, so the other form is used.
TEST(ConstraintCorrection, ServesAVertexWithManyPanels) {
  constexpr int kPanels = 100;
  const double pi = std::acos(-1.0);
  Mesh mesh;
  mesh.positions.resize(3, 1 + 2 * kPanels);
  mesh.positions.col(0).setZero();
  for (int k = 0; k < 2 * kPanels; ++k) {
    const double angle = pi * k / kPanels, radius = 20.0 + (k % 2);
    mesh.positions.col(1 + k) =
        Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  for (int k = 0; k < kPanels; ++k) {
    for (const int v : {0, 1 + 2 * k, 2 + 2 * k, 1 + (2 * k + 2) % (2 * kPanels)}) {
      mesh.face_vertices.push_back(v);
    }
    mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
  }
  ProblemOnMesh on_mesh(mesh);
  const Patch patch = on_mesh.cut_all();
  ConstraintCorrection correction;
  EXPECT_FALSE(correction.attach(patch));
  Eigen::Matrix3Xd displacement = 0.02 * testing::random_points(1, patch.free_count);
  int factorizations = 0;
  EXPECT_LT(correct_constraints(patch, 20, displacement, factorizations), 1e-9);
}

}  // namespace
}  // namespace planish
