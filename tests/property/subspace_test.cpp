// SPDX-License-Identifier: MIT
/// Problem (7): an orthonormal, tangent, local family of variations.
#include "planish/variations/subspace.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/measures/metrics.hpp"
#include "planish/problem/problem.hpp"
#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kPromise = 1e-8;  ///< orthonormality and tangency

class SubspaceOn : public ::testing::TestWithParam<const char*> {
 protected:
  SubspaceOn()
      : mesh(testing::sample(GetParam(), testing::by_night(20, 14))),
        handle(testing::middle_vertex(mesh)),
        edit(solve_handle_edit(mesh, testing::pull(mesh, handle, {0, 0, 0.6}))),
        edited(mesh) {
    edited.positions = apply(mesh, edit);
  }

  [[nodiscard]] Subspace compute(const SubspaceOptions& options) const {
    return compute_subspace(mesh, edited.positions, {handle}, options);
  }

  /// Column j as a displacement of the whole mesh.
  [[nodiscard]] Positions vector(const Subspace& subspace, Eigen::Index j) const {
    Positions t = Positions::Zero(3, mesh.vertex_count());
    for (std::size_t k = 0; k < subspace.support.size(); ++k) {
      t.col(subspace.support[k]) =
          subspace.basis.col(j).segment<3>(3 * static_cast<Eigen::Index>(k));
    }
    return t;
  }

  void expect_orthonormal(const Subspace& subspace) const;
  void expect_tangent(const Subspace& subspace) const;
  void expect_overlap(const Subspace& subspace) const;
  void expect_fair(const Subspace& subspace) const;
  void expect_flat_to_second_order(const Subspace& subspace) const;
  void expect_same_space(const Subspace& plain, const Subspace& eigen) const;
  void expect_edit_at_zero(const Subspace& subspace) const;
  void expect_scale_of_edit(const Subspace& subspace) const;

  Mesh mesh;
  int handle;
  HandleEditResult edit;
  Mesh edited;
};

/// One family of four, and its eigenbasis, held against all that is stated of them.
TEST_P(SubspaceOn, IsOrthonormalTangentAndLikeTheEdit) {
  const Subspace subspace = compute({.dimension = 4});
  ASSERT_EQ(subspace.dimension(), 4) << status_name(subspace.report.status);
  expect_orthonormal(subspace);
  expect_tangent(subspace);
  expect_overlap(subspace);
  expect_fair(subspace);
  expect_flat_to_second_order(subspace);
  expect_same_space(subspace, compute({.dimension = 4, .eigenbasis = true}));
}

void SubspaceOn::expect_orthonormal(const Subspace& subspace) const {
  const Eigen::MatrixXd gram = subspace.basis.transpose() * subspace.basis;
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(4, 4)).lpNorm<Eigen::Infinity>(), kPromise);
  EXPECT_LT(subspace.report.orthonormality_error, kPromise);
}

/// [SUB-8]
TEST_P(SubspaceOn, ConvergedMeansCertifiedAndStartsAtTheEdit) {
  const Subspace subspace = compute({.dimension = 2});
  ASSERT_EQ(subspace.report.certificates.size(), 2U);
  bool met = true;
  for (const Optimality& one : subspace.report.certificates) {
    met = met && one.stationarity <= 1e-4 && one.outside <= 1e-4;
    EXPECT_GT(one.certified_vertices, 0);
  }
  EXPECT_EQ(subspace.report.status == SolveStatus::kConverged, met);
  expect_edit_at_zero(subspace);
  expect_scale_of_edit(subspace);
}

TEST_P(SubspaceOn, TheSmoothestOfALargerFamilyAreSmoother) {
  const Subspace own = compute({.dimension = 2, .eigenbasis = true});
  const Subspace chosen = compute({.dimension = 2, .eigenbasis = true, .family = 5});
  ASSERT_EQ(chosen.dimension(), 2);
  EXPECT_EQ(chosen.report.certificates.size(), 5U);
  EXPECT_LE(chosen.report.fairness.front(), own.report.fairness.front() * (1.0 + 1e-9));
  EXPECT_LE(chosen.report.fairness.back(), own.report.fairness.back() * (1.0 + 1e-9));
}

TEST_P(SubspaceOn, MovesNoPin) {
  const std::vector<int> pins{edit.moved.front(), handle};
  const Subspace subspace =
      compute_subspace(mesh, edited.positions, {handle}, {.dimension = 3}, {.held = pins});
  ASSERT_EQ(subspace.dimension(), 3) << status_name(subspace.report.status);
  for (const int pin : pins) {
    EXPECT_FALSE(std::binary_search(subspace.support.begin(), subspace.support.end(), pin)) << pin;
  }
  EXPECT_LT(subspace.report.tangency_error, kPromise);
  EXPECT_LT(subspace.report.orthonormality_error, kPromise);
}

/// J t = 0 with J assembled here, at p⁺, in units of the mean edge.
void SubspaceOn::expect_tangent(const Subspace& subspace) const {
  const MeshModel model(edited, FairnessKind::kSecondDifference);
  for (Eigen::Index j = 0; j < subspace.dimension(); ++j) {
    const Positions t = vector(subspace, j);
    double worst = 0.0;
    for (const FlatnessEquation& equation : model.equations.of<PlanarPolygon>()) {
      FourPoints points, motion;
      for (int k = 0; k < 4; ++k) {
        const int v = equation.vertices[static_cast<std::size_t>(k)];
        points.col(k) = model.points.col(v);
        motion.col(k) = t.col(v);
      }
      worst = std::max(worst, std::abs(gradient(equation, points).cwiseProduct(motion).sum()));
    }
    EXPECT_LT(worst, kPromise) << "vector " << j;
  }
  EXPECT_LT(subspace.report.tangency_error, kPromise);
}

TEST_P(SubspaceOn, StaysWithinReachOfTheEdit) {
  for (const int reach : {1, 2}) {
    const Subspace subspace = compute({.dimension = 3, .reach = reach});
    std::vector<int> allowed;
    for (const int v : edit.moved) {
      const std::vector<int> near = testing::ring_neighbourhood(mesh, v, reach);
      allowed.insert(allowed.end(), near.begin(), near.end());
    }
    std::sort(allowed.begin(), allowed.end());
    EXPECT_TRUE(std::is_sorted(subspace.support.begin(), subspace.support.end()));
    for (const int v : subspace.support) {
      EXPECT_TRUE(std::binary_search(allowed.begin(), allowed.end(), v)) << v;
    }
  }
}

/// [SUB-3]: ξ(d̄, t) is between 0 and 1, and the vectors overlap the edit.
void SubspaceOn::expect_overlap(const Subspace& subspace) const {
  const Positions d =
      (edited.positions - mesh.positions) / (edited.positions - mesh.positions).norm();
  for (Eigen::Index j = 0; j < subspace.dimension(); ++j) {
    const double expected = vector(subspace, j).colwise().norm().dot(d.colwise().norm());
    const double reported = subspace.report.correlation[static_cast<std::size_t>(j)];
    EXPECT_NEAR(reported, expected, 1e-9);
    EXPECT_GE(reported, 0.1);
    EXPECT_LE(reported, 1.0 + 1e-12);
  }
}

/// [SUB-1]: each vector is about as fair as the edit itself, not a spike.
void SubspaceOn::expect_fair(const Subspace& subspace) const {
  const FairnessOperator e =
      fairness_operator(mesh, build_adjacency(mesh), FairnessKind::kSecondDifference);
  for (Eigen::Index j = 0; j < subspace.dimension(); ++j) {
    const double fairness = (e * vector(subspace, j).transpose()).squaredNorm();
    EXPECT_NEAR(subspace.report.fairness[static_cast<std::size_t>(j)], fairness,
                1e-9 * (1 + fairness));
    EXPECT_LT(fairness, 3.0 * subspace.report.edit_fairness);
  }
}

/// Small coefficients leave the panels flat to second order.
void SubspaceOn::expect_flat_to_second_order(const Subspace& subspace) const {
  const auto planarity = [&](double size) {
    Positions rows, all = edited.positions;
    evaluate(subspace, size * Eigen::VectorXd::Ones(subspace.dimension()), rows);
    for (std::size_t k = 0; k < subspace.support.size(); ++k) {
      all.col(subspace.support[k]) = rows.col(static_cast<Eigen::Index>(k));
    }
    return planarity_summary(mesh, all).max;
  };
  const double coarse = planarity(0.02), fine = planarity(0.002);
  EXPECT_LT(fine, 0.015 * coarse + 1e-6);
}

/// [SUB-5]: another basis of the same space, smallest Q first.
void SubspaceOn::expect_same_space(const Subspace& plain, const Subspace& eigen) const {
  ASSERT_EQ(plain.support, eigen.support);
  const Eigen::MatrixXd overlap = plain.basis.transpose() * eigen.basis;
  EXPECT_LT((overlap.transpose() * overlap - Eigen::MatrixXd::Identity(4, 4)).norm(), 1e-7);
  EXPECT_TRUE(std::is_sorted(eigen.report.fairness.begin(), eigen.report.fairness.end(),
                             [](double a, double b) { return a < b - 1e-9; }));
}

/// [SUB-6]: Appendix B as the paper has it, finished exactly.
TEST_P(SubspaceOn, TheReferenceEngineKeepsTheSamePromises) {
  const Subspace subspace = compute({.dimension = 2, .engine = Engine::kAugmentedLagrangian});
  EXPECT_EQ(subspace.dimension(), 2);
  EXPECT_LT(subspace.report.orthonormality_error, kPromise);
  EXPECT_LT(subspace.report.tangency_error, kPromise);
}

void SubspaceOn::expect_edit_at_zero(const Subspace& subspace) const {
  Positions rows;
  evaluate(subspace, Eigen::VectorXd::Zero(subspace.dimension()), rows);
  for (std::size_t k = 0; k < subspace.support.size(); ++k) {
    EXPECT_EQ(Eigen::Vector3d(rows.col(static_cast<Eigen::Index>(k))),
              Eigen::Vector3d(edited.positions.col(subspace.support[k])));
  }
}

/// [SUB-2]: coefficient 1 moves some vertex by the edit's own largest move.
void SubspaceOn::expect_scale_of_edit(const Subspace& subspace) const {
  Positions rows;
  evaluate(subspace, Eigen::VectorXd::Unit(subspace.dimension(), 0), rows);
  EXPECT_NEAR((rows - subspace.origin).colwise().norm().maxCoeff(), edit.report.max_displacement,
              1e-9);
}

INSTANTIATE_TEST_SUITE_P(Meshes, SubspaceOn, ::testing::Values("vault", "dome", "hex", "trihex"));

/// [SUB-2]: a higher sparsity weight never gives a wider family.
TEST(Subspace, ShrinksWithItsSparsityWeight) {
  const Mesh mesh = testing::sample("dome", 24);
  const int handle = testing::middle_vertex(mesh);
  const Positions edited =
      apply(mesh, solve_handle_edit(mesh, testing::pull(mesh, handle, {0, 0, 0.6})));
  const auto first_support = [&](double weight) {
    return compute_subspace(mesh, edited, {handle}, {.dimension = 1, .sparsity_weight = weight})
        .report.support_sizes[0];
  };
  EXPECT_LE(first_support(10.0), first_support(0.1));
}

TEST(Subspace, OfAMeshThatDidNotMoveIsEmpty) {
  const Mesh mesh = testing::sample("vault", 10);
  const Subspace subspace = compute_subspace(mesh, mesh.positions, {}, {});
  EXPECT_EQ(subspace.dimension(), 0);
  EXPECT_TRUE(subspace.support.empty());
}

TEST(SubspaceOptions, NameWhatIsWrong) {
  const auto problem = [](const SubspaceOptions& options) {
    return find_problem(options).value_or("");
  };
  EXPECT_EQ(problem({}), "");
  EXPECT_NE(problem({.dimension = 0}).find("dimension"), std::string::npos);
  EXPECT_NE(problem({.dimension = 25}).find("dimension"), std::string::npos);
  EXPECT_NE(problem({.correlation = 1.0}).find("correlation"), std::string::npos);
  EXPECT_NE(problem({.reach = -1}).find("reach"), std::string::npos);
}

}  // namespace
}  // namespace planish
