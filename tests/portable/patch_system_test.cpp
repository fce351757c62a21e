// SPDX-License-Identifier: MIT
#include "engines/patch_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::ProblemOnMesh;

constexpr double kSmoothing = 0.1;
constexpr double kPenalty = 100.0;
constexpr double kLimitPenalty = 7e2;
constexpr double kShift = 5.0;  ///< enough to make a random state positive definite

/// A patch with a halo that has moved, a handle, and random primal and dual variables.
class SystemOn : public ::testing::TestWithParam<const char*> {
 protected:
  SystemOn() : on_mesh(testing::sample(GetParam(), 8)) {
    const int middle = testing::middle_vertex(on_mesh.model.mesh);
    on_mesh.problem.fairness_weight = 0.8;
    on_mesh.add_handle(middle, {0.1, 0.2, 0.5});
    patch = on_mesh.cut(testing::ring_neighbourhood(on_mesh.model.mesh, middle, 1));
    patch.displacement = 0.1 * testing::random_points(1, patch.local_count());
    state.displacement = 0.2 * testing::random_points(2, patch.free_count);
    state.multipliers =
        0.1 * testing::random_vector(3, static_cast<Eigen::Index>(patch.equations.size()));
    state.norm_dual = consistent_dual(state.displacement);
    system.attach(patch);
  }

  /// w = d/√(‖d‖² + ε²): with it the matrix is the exact Hessian.
  static Eigen::Matrix3Xd consistent_dual(const Eigen::Matrix3Xd& d) {
    Eigen::Matrix3Xd w = d;
    for (auto column : w.colwise()) {
      column /= std::sqrt(column.squaredNorm() + kSmoothing * kSmoothing);
    }
    return w;
  }

  /// Limits on three sides of a panel: the first presses, the second would.
  /// @returns the number of the first
  Eigen::Index add_limits() {
    const std::vector<int> panel(patch.faces[0].begin(), patch.faces[0].end());
    for (std::size_t k = 0; k < 3; ++k) {
      EdgeRow row;
      row.vertices = {panel[k], panel[k + 1]};
      const double share = k == 2 ? 0.9 : -0.2;
      row.scale = {0.7, 0.0};
      row.scale.offset =
          share - row.scale.share(value(row, corners_at(patch, state.displacement, row)));
      patch.inequalities.of<EdgeLimit>().push_back(row);
    }
    system.attach(patch);
    const auto first = static_cast<Eigen::Index>(patch.inequalities.of<ShapeBound>().size() +
                                                 patch.inequalities.of<FoldLimit>().size() +
                                                 patch.inequalities.of<AngleLimit>().size());
    state.limit_multipliers.setZero(static_cast<Eigen::Index>(patch.inequalities.size()));
    state.limit_multipliers[first] = 0.7;
    system.evaluate_limits(state.displacement);
    return first;
  }

  [[nodiscard]] std::vector<char> with_limits(Eigen::Index first,
                                              const std::array<char, 3>& active) const {
    std::vector<char> all(patch.inequalities.size(), 0);
    std::copy(active.begin(), active.end(), all.begin() + first);
    return all;
  }

  [[nodiscard]] double lagrangian(const Eigen::Matrix3Xd& d) const {
    Eigen::VectorXd c;
    system.lagrangian().residuals(d, c);
    double sum = system.lagrangian().energy(d, kSmoothing) + state.multipliers.dot(c);
    if (state.limit_multipliers.size() == 0) return sum;
    Eigen::VectorXd shares;
    system.lagrangian().shares(d, shares);
    return sum - state.limit_multipliers.dot(shares);
  }

  [[nodiscard]] Eigen::VectorXd gradient_at(const Eigen::Matrix3Xd& d) const {
    PatchState there = state;
    there.displacement = d;
    Eigen::Matrix3Xd out;
    system.lagrangian().gradient_at(there, kSmoothing, out);
    return Eigen::Map<const Eigen::VectorXd>(out.data(), out.size());
  }

  /// Column k of the derivative of `function` at the state.
  template <class Function>
  [[nodiscard]] Eigen::MatrixXd differences(const Function& function) const {
    constexpr double kStep = 1e-5;
    Eigen::MatrixXd columns;
    for (Eigen::Index k = 0; k < state.displacement.size(); ++k) {
      Eigen::Matrix3Xd ahead = state.displacement, behind = state.displacement;
      ahead.data()[k] += kStep;
      behind.data()[k] -= kStep;
      const Eigen::VectorXd column = (function(ahead) - function(behind)) / (2 * kStep);
      columns.conservativeResize(column.size(), k + 1);
      columns.col(k) = column;
    }
    return columns;
  }

  [[nodiscard]] Eigen::VectorXd residuals_of(const Eigen::Matrix3Xd& d) const {
    Eigen::VectorXd c;
    system.lagrangian().residuals(d, c);
    return c;
  }

  /// [WSN-2]: [H + νI, Jᵀ; J, −I/μ] (δ, Δλ) = −(∇F + Jᵀλ, c), solved densely with H from finite
  /// differences of the gradient. Inequalities that are active are rows like the equations, with
  /// no residual of their own here.
  /// @param limits the gradients of their shares, one a row
  void expect_step_solves_the_kkt_system(const Eigen::MatrixXd& limits = {}) {
    // A polygon's equations leave out curvature that is a multiple of c or ∇c: compare without λ
    // there.
    if (patch.equations.of<PlanarPolygon>().front().least_area > 0.0) state.multipliers.setZero();
    ASSERT_TRUE(system.factorize(state, kSmoothing, kPenalty, kShift));
    const Eigen::VectorXd c = residuals_of(state.displacement);
    const Eigen::VectorXd g = gradient_at(state.displacement);
    Eigen::Matrix3Xd delta;
    system.step(Eigen::Map<const Eigen::Matrix3Xd>(g.data(), 3, patch.free_count), c, delta);

    const Eigen::MatrixXd hessian =
        differences([&](const Eigen::Matrix3Xd& d) { return gradient_at(d); });
    const Eigen::MatrixXd jacobian =
        differences([&](const Eigen::Matrix3Xd& d) { return residuals_of(d); });
    const Eigen::Index n = hessian.rows(), m = jacobian.rows(), k = limits.rows();
    EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-6 * hessian.norm());
    Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + m + k, n + m + k);
    kkt.topLeftCorner(n, n) = hessian + kShift * Eigen::MatrixXd::Identity(n, n);
    kkt.block(0, n, n, m) = jacobian.transpose();
    kkt.block(n, 0, m, n) = jacobian;
    kkt.block(n, n, m, m) = -Eigen::MatrixXd::Identity(m, m) / kPenalty;
    if (k > 0) {
      kkt.topRightCorner(n, k) = limits.transpose();
      kkt.bottomLeftCorner(k, n) = limits;
      kkt.bottomRightCorner(k, k) = -Eigen::MatrixXd::Identity(k, k) / kLimitPenalty;
    }
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + m + k);
    right.head(n + m) << -g, -c;
    const Eigen::VectorXd expected = kkt.fullPivLu().solve(right);
    const Eigen::Map<const Eigen::VectorXd> flat(delta.data(), n);
    EXPECT_LT((flat - expected.head(n)).norm(), 1e-6 * expected.head(n).norm());
    Eigen::VectorXd image;
    system.apply_jacobian(delta, image);
    EXPECT_LT((kPenalty * (c + image) - expected.segment(n, m)).norm(),
              1e-5 * expected.segment(n, m).norm());
  }

  ProblemOnMesh on_mesh;
  Patch patch;
  PatchState state;
  PatchSystem system;
};

TEST_P(SystemOn, EnergyWithoutSmoothingIsTheObjective) {
  Patch moved = patch;
  moved.displacement.leftCols(patch.free_count) = state.displacement;
  const double expected = objective(moved).total();
  EXPECT_NEAR(system.lagrangian().energy(state.displacement, 0.0), expected, 1e-12 * expected);
}

TEST_P(SystemOn, GradientIsTheDerivativeOfTheLagrangian) {
  const Eigen::VectorXd expected = differences([&](const Eigen::Matrix3Xd& d) {
                                     return Eigen::VectorXd::Constant(1, lagrangian(d));
                                   }).row(0);
  const Eigen::VectorXd actual = gradient_at(state.displacement);
  EXPECT_LT((actual - expected).lpNorm<Eigen::Infinity>(), 1e-7 * actual.norm());
}

TEST_P(SystemOn, JacobianIsTheDerivativeOfTheResiduals) {
  ASSERT_TRUE(system.factorize(state, kSmoothing, kPenalty, kShift));
  const Eigen::MatrixXd jacobian =
      differences([&](const Eigen::Matrix3Xd& d) { return residuals_of(d); });
  const Eigen::Matrix3Xd delta = testing::random_points(9, patch.free_count);
  Eigen::VectorXd image;
  system.apply_jacobian(delta, image);
  const Eigen::Map<const Eigen::VectorXd> flat(delta.data(), delta.size());
  EXPECT_LT((image - jacobian * flat).norm(), 1e-8 * image.norm());
}

TEST_P(SystemOn, StepSolvesTheKktSystem) { expect_step_solves_the_kkt_system(); }

/// [KEE-1] [KEE-2]: rows that a barrier acts on, that none does, and of a point that rests.
TEST_P(SystemOn, KnowsKeepOuts) {
  const double bare = lagrangian(state.displacement);
  patch.keep_out_weight = 0.7;
  for (int v = 0; v < std::min(4, patch.free_count); ++v) {
    const Eigen::Vector3d place = patch.points.col(v) + state.displacement.col(v);
    KeepOutRow row;
    row.vertices = {v};
    row.normal = testing::random_points(30 + static_cast<unsigned>(v), 1).normalized();
    row.rests = v == 1;
    const double share = v == 1 ? -0.02 : v == 2 ? 0.9 : 0.2;
    row.scale = {1.5, share - 1.5 * row.normal.dot(place)};
    patch.inequalities.of<KeepOutPlane>().push_back(row);
  }
  system.attach(patch);
  EXPECT_GT(lagrangian(state.displacement), bare);
  const Eigen::VectorXd expected = differences([&](const Eigen::Matrix3Xd& d) {
                                     return Eigen::VectorXd::Constant(1, lagrangian(d));
                                   }).row(0);
  const Eigen::VectorXd actual = gradient_at(state.displacement);
  EXPECT_LT((actual - expected).lpNorm<Eigen::Infinity>(), 1e-6 * actual.norm());
  expect_step_solves_the_kkt_system();
}

/// [LIM-2]: an inequality that presses, one that is active and does not press yet, one that is
/// neither.
TEST_P(SystemOn, KnowsLimits) {
  const double bare = lagrangian(state.displacement);
  const Eigen::Index first = add_limits();
  EXPECT_TRUE(system.has_limits());
  system.activate(with_limits(first, {1, 1, 0}), kLimitPenalty);
  EXPECT_GT(lagrangian(state.displacement), bare);
  const Eigen::VectorXd expected = differences([&](const Eigen::Matrix3Xd& d) {
                                     return Eigen::VectorXd::Constant(1, lagrangian(d));
                                   }).row(0);
  const Eigen::VectorXd actual = gradient_at(state.displacement);
  EXPECT_LT((actual - expected).lpNorm<Eigen::Infinity>(), 1e-6 * actual.norm());
  const Eigen::MatrixXd shares = differences([&](const Eigen::Matrix3Xd& d) {
    Eigen::VectorXd out;
    system.lagrangian().shares(d, out);
    return out;
  });
  expect_step_solves_the_kkt_system(shares.middleRows(first, 2));
}

/// [LIM-2]: by solves the system has the same rows as by another factorization.
TEST_P(SystemOn, ChangesItsLimitsBySolves) {
  const Eigen::Index first = add_limits();
  using Active = std::array<char, 3>;
  constexpr std::array<Active, 4> kSets{Active{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}};
  const auto factorized = [&](const Active& active) {
    system.activate(with_limits(first, active), kLimitPenalty);
    return system.factorize(state, kSmoothing, kPenalty, kShift);
  };
  for (const Active& from : kSets) {
    for (const Active& to : kSets) {
      ASSERT_TRUE(factorized(to));
      const Eigen::Matrix3Xd pulls = testing::random_points(7, patch.free_count);
      Eigen::Matrix3Xd expected = pulls, actual = pulls;
      system.apply_inverse(expected);
      ASSERT_TRUE(factorized(from));
      system.activate(with_limits(first, to), kLimitPenalty);
      const int before = system.factorizations();
      ASSERT_TRUE(system.update());
      EXPECT_EQ(system.factorizations(), before);
      system.apply_inverse(actual);
      EXPECT_LT((actual - expected).norm(), 1e-9 * expected.norm());
    }
  }
}

/// [LIM-2]: a row stays without which there is no minimum; what was asked for before stands.
TEST_P(SystemOn, KeepsALimitThatItsDefinitenessHangsOn) {
  const Eigen::Index first = add_limits();
  const RowJacobian& rows = system.limit_jacobian();
  const auto gradient_of = [&](Eigen::Index row) {
    const Eigen::Matrix3Xd g = rows.transposed(static_cast<int>(row));
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(g.data(), g.size()));
  };
  // A side between points that stay is no row: two of the others.
  const Eigen::Index one = gradient_of(first).norm() > 0.0 ? first : first + 1;
  const auto active = [&](char one_is, char next_is) {
    std::vector<char> all(patch.inequalities.size(), 0);
    all[static_cast<std::size_t>(one)] = one_is;
    all[static_cast<std::size_t>(one) + 1] = next_is;
    return all;
  };
  const Eigen::VectorXd bent = gradient_of(one), other = gradient_of(one + 1);
  // Without `bent` negative along what is across `other`, by so little that `bent` makes up for it.
  const Eigen::VectorXd across = bent - other.dot(bent) / other.squaredNorm() * other;
  const double share = across.squaredNorm() / bent.squaredNorm();
  ASSERT_GT(kLimitPenalty * bent.squaredNorm(), 1.0);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(bent.size(), bent.size());
  matrix -= (1.0 + 0.5 * share) / across.squaredNorm() * across * across.transpose();
  matrix += kLimitPenalty * bent * bent.transpose();
  const Eigen::MatrixXd inverse = matrix.inverse();
  const auto solve = [&](Eigen::Matrix3Xd& x) {
    Eigen::Map<Eigen::VectorXd> flat(x.data(), x.size());
    flat = (inverse * flat).eval();
  };
  RowUpdate update;
  update.begin(active(1, 0));
  ASSERT_TRUE(update.set(active(1, 1), kLimitPenalty, rows, solve));
  EXPECT_FALSE(update.set(active(0, 1), kLimitPenalty, rows, solve));
  const Eigen::Matrix3Xd pulls = testing::random_points(7, patch.free_count);
  Eigen::Matrix3Xd expected = pulls, actual = pulls;
  solve(actual);
  update.apply(rows, actual);
  matrix += kLimitPenalty * other * other.transpose();
  Eigen::Map<Eigen::VectorXd> flat(expected.data(), expected.size());
  flat = matrix.ldlt().solve(flat.eval());
  EXPECT_LT((actual - expected).norm(), 1e-9 * expected.norm());
}

/// [SUP-2]: the same system in coordinates along what every vertex may do.
TEST_P(SystemOn, StepStaysOnTheSupports) {
  // See StepSolvesTheKktSystem.
  if (patch.equations.of<PlanarPolygon>().front().least_area > 0.0) state.multipliers.setZero();
  const Eigen::MatrixXd hessian =
      differences([&](const Eigen::Matrix3Xd& d) { return gradient_at(d); });
  const Eigen::MatrixXd jacobian =
      differences([&](const Eigen::Matrix3Xd& d) { return residuals_of(d); });
  const Eigen::VectorXd c = residuals_of(state.displacement);
  const Eigen::VectorXd whole = gradient_at(state.displacement);
  Eigen::MatrixXd along = Eigen::MatrixXd::Identity(whole.size(), whole.size());
  for (int v = 0; v < patch.free_count; v += 2) {
    const Eigen::Vector3d t = testing::random_points(20 + static_cast<unsigned>(v), 1).normalized();
    const Eigen::Matrix3d line = t * t.transpose();
    const Eigen::Matrix3d plane = Eigen::Matrix3d::Identity() - line;
    patch.slides.push_back({v, {.along = v % 4 == 0 ? line : plane}});
    along.block<3, 3>(3 * v, 3 * v) = patch.slides.back().track.along;
  }
  system.attach(patch);
  ASSERT_TRUE(system.factorize(state, kSmoothing, kPenalty, kShift));
  const Eigen::VectorXd g = gradient_at(state.displacement);
  EXPECT_LT((g - along * whole).norm(), 1e-14 * whole.norm());
  Eigen::Matrix3Xd delta;
  system.step(Eigen::Map<const Eigen::Matrix3Xd>(g.data(), 3, patch.free_count), c, delta);
  const Eigen::Map<const Eigen::VectorXd> flat(delta.data(), delta.size());
  EXPECT_LT((along * flat - flat).norm(), 1e-14 * flat.norm());

  const Eigen::MatrixXd basis = along.colPivHouseholderQr().householderQ() *
                                Eigen::MatrixXd::Identity(whole.size(), std::lround(along.trace()));
  const Eigen::MatrixXd bend = hessian +
                               kShift * Eigen::MatrixXd::Identity(whole.size(), whole.size()) +
                               kPenalty * jacobian.transpose() * jacobian;
  const Eigen::VectorXd pull = -(whole + kPenalty * jacobian.transpose() * c);
  const Eigen::VectorXd y =
      (basis.transpose() * bend * basis).fullPivLu().solve(basis.transpose() * pull);
  EXPECT_LT((flat - basis * y).norm(), 1e-6 * flat.norm());
}

/// The factorization fails exactly when the KKT matrix does not have the inertia of a minimum.
TEST_P(SystemOn, RefusesAnIndefiniteSystem) {
  state.multipliers *= 1e4;  // curvature of the constraints overwhelms everything else
  EXPECT_FALSE(system.factorize(state, kSmoothing, kPenalty, 0.0));
  EXPECT_TRUE(system.factorize(state, kSmoothing, kPenalty, 1e5));
}

INSTANTIATE_TEST_SUITE_P(Meshes, SystemOn, ::testing::Values("vault", "dome", "hex", "trihex"));

}  // namespace
}  // namespace planish
