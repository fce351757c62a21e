// SPDX-License-Identifier: MIT
#include "planish/constraints/planar_polygon.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "support/scenes.hpp"

namespace planish {
namespace {

using testing::random_points;

constexpr double kStep = 1e-6;             ///< of a central difference
constexpr double kDifferenceError = 1e-8;  ///< what rounding leaves of it, values of order 1
constexpr double kUnitRounding = 1e-12;

/// A quad whose corners are the four points, in order.
const FlatnessEquation kEquation{{0, 1, 2, 3}, 0.7, 0.0};

FourPoints four_points(unsigned seed) { return random_points(seed, 4); }

/// The residual's derivative by coordinate k, by a central difference.
double slope_of_residual(const FlatnessEquation& equation, const FourPoints& points, int k) {
  FourPoints ahead = points, behind = points;
  ahead(k % 3, k / 3) += kStep;
  behind(k % 3, k / 3) -= kStep;
  return (residual(equation, ahead) - residual(equation, behind)) / (2 * kStep);
}

/// The gradient's.
Eigen::Matrix<double, 12, 1> slope_of_gradient(const FlatnessEquation& equation,
                                               const FourPoints& points, int k) {
  FourPoints ahead = points, behind = points;
  ahead(k % 3, k / 3) += kStep;
  behind(k % 3, k / 3) -= kStep;
  const FourPoints column = (gradient(equation, ahead) - gradient(equation, behind)) / (2 * kStep);
  return Eigen::Map<const Eigen::Matrix<double, 12, 1>>(column.data());
}

/// hessian(), all of it.
Eigen::Matrix<double, 12, 12> dense_hessian(const FlatnessEquation& equation,
                                            const FourPoints& points) {
  const auto blocks = hessian(equation, points);
  Eigen::Matrix<double, 12, 12> dense;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j <= i; ++j) {
      const Eigen::Matrix3d& block = blocks[block_index<FlatnessEquation>(i, j)];
      dense.block<3, 3>(3 * j, 3 * i) = block.transpose();
      dense.block<3, 3>(3 * i, 3 * j) = block;
    }
  }
  return dense;
}

class FlatnessEquationAt : public ::testing::TestWithParam<unsigned> {};

TEST_P(FlatnessEquationAt, GradientIsTheDerivativeOfTheResidual) {
  const FourPoints points = four_points(GetParam());
  const FourPoints derivative = gradient(kEquation, points);
  for (int k = 0; k < 12; ++k) {
    const double difference = slope_of_residual(kEquation, points, k);
    EXPECT_NEAR(derivative(k % 3, k / 3), difference, kDifferenceError);
  }
}

/// Where the scale follows the triangle that carries a polygon's plane, its derivative counts.
TEST_P(FlatnessEquationAt, GradientFollowsTheScaleOfAPolygon) {
  for (const double least_area : {1e-3, 100.0}) {  // following, and at its bound
    const FlatnessEquation equation{{0, 1, 2, 3}, 0.7, least_area};
    const FourPoints points = four_points(GetParam());
    const FourPoints derivative = gradient(equation, points);
    for (int k = 0; k < 12; ++k) {
      const double difference = slope_of_residual(equation, points, k);
      EXPECT_NEAR(derivative(k % 3, k / 3), difference, 1e-7 * (1 + derivative.norm()));
    }
  }
}

TEST_P(FlatnessEquationAt, HessianIsTheDerivativeOfTheGradient) {
  const FourPoints points = four_points(GetParam());
  const Eigen::Matrix<double, 12, 12> dense = dense_hessian(kEquation, points);
  for (int k = 0; k < 12; ++k) {
    EXPECT_LT((dense.col(k) - slope_of_gradient(kEquation, points, k)).lpNorm<Eigen::Infinity>(),
              kDifferenceError)
        << "column " << k;
  }
}

/// Four points that are out of flat, and the equations by which they stay so: of a quad, and of
/// four corners of a larger panel.
std::vector<std::pair<FlatnessEquation, FourPoints>> bent_equations(unsigned seed) {
  std::vector<std::pair<FlatnessEquation, FourPoints>> found;
  const FourPoints square{{0, 1.3, 1, 0}, {0, 0, 1.1, 1}, {0, 0, 0, 0}};
  const FourPoints points = square + 0.1 * four_points(seed);
  for (const bool is_quad : {true, false}) {
    const FlatnessEquation bent = bent_equation(points, kEquation, is_quad);
    found.emplace_back(bent, points(Eigen::all, bent.vertices));
  }
  return found;
}

TEST_P(FlatnessEquationAt, ABentPanelMeetsItsOwnEquationAtEverySizeAndPlace) {
  for (const auto& [equation, points] : bent_equations(GetParam())) {
    EXPECT_GT(std::abs(equation.bend), 1e-4);
    EXPECT_NEAR(residual(equation, points), 0.0, kUnitRounding);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const FourPoints elsewhere = (1.7 * turn * points).colwise() + Eigen::Vector3d(3, -2, 5);
    EXPECT_NEAR(residual(equation, elsewhere), 0.0, 1e-11);
  }
}

TEST_P(FlatnessEquationAt, GradientOfABentPanelIsTheDerivativeOfItsResidual) {
  for (const auto& [equation, points] : bent_equations(GetParam())) {
    const FourPoints derivative = gradient(equation, points);
    for (int k = 0; k < 12; ++k) {
      const double difference = slope_of_residual(equation, points, k);
      EXPECT_NEAR(derivative(k % 3, k / 3), difference, kDifferenceError);
    }
  }
}

/// Along directions that keep the bend.
TEST_P(FlatnessEquationAt, HessianOfABentPanelIsTheDerivativeOfItsGradient) {
  using Flat = Eigen::Matrix<double, 12, 1>;
  using Square = Eigen::Matrix<double, 12, 12>;
  for (const auto& [equation, points] : bent_equations(GetParam())) {
    Square differences;
    for (int k = 0; k < 12; ++k) differences.col(k) = slope_of_gradient(equation, points, k);
    const FourPoints slope = gradient(equation, points);
    const Flat normal = Eigen::Map<const Flat>(slope.data()).normalized();
    const Square along = Square::Identity() - normal * normal.transpose();
    EXPECT_LT(
        (along * (dense_hessian(equation, points) - differences) * along).cwiseAbs().maxCoeff(),
        1e-7);
  }
}

TEST_P(FlatnessEquationAt, ResidualIgnoresTranslationAndRotation) {
  const FourPoints points = four_points(GetParam());
  const Eigen::Vector3d axis = random_points(GetParam() + 100, 1).col(0).normalized();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, axis).toRotationMatrix();
  const FourPoints moved = (turn * points).colwise() + Eigen::Vector3d(3, -2, 5);
  EXPECT_NEAR(residual(kEquation, moved), residual(kEquation, points), 1e-11);
}

/// A residual is a length: the distance between the diagonals of a quad.
TEST_P(FlatnessEquationAt, ResidualOfAQuadIsTheDistanceOfItsDiagonals) {
  const Positions points = random_points(GetParam(), 4);
  const std::vector<int> face{0, 1, 2, 3};
  std::vector<FlatnessEquation> equations;
  append_flatness_equations(points, face, equations);
  ASSERT_EQ(equations.size(), 1u);
  const Eigen::Vector3d first = points.col(2) - points.col(0);
  const Eigen::Vector3d second = points.col(3) - points.col(1);
  const double distance =
      std::abs(first.cross(second).normalized().dot(points.col(1) - points.col(0)));
  EXPECT_NEAR(std::abs(residual(equations[0], points)), distance, kUnitRounding);
}

/// n − 3 equations; all zero exactly where the polygon is flat, and one of them large where a
/// vertex leaves the plane.
TEST_P(FlatnessEquationAt, PolygonsHaveOneEquationPerVertexBeyondThree) {
  for (int size = 3; size <= 12; ++size) {
    Positions points(3, size);
    const Eigen::VectorXd noise = testing::random_vector(GetParam(), size);
    for (int k = 0; k < size; ++k) {
      const double angle = 2 * std::acos(-1.0) * k / size;
      const double radius = 1.0 + 0.1 * noise[k];
      points.col(k) = Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    std::vector<int> face(static_cast<std::size_t>(size));
    std::iota(face.begin(), face.end(), 0);
    std::vector<FlatnessEquation> equations;
    append_flatness_equations(points, face, equations);
    ASSERT_EQ(equations.size(), static_cast<std::size_t>(size - 3));
    const auto worst = [&] {
      double largest = 0.0;
      for (const FlatnessEquation& equation : equations) {
        FourPoints corners;
        for (int k = 0; k < 4; ++k)
          corners.col(k) = points.col(equation.vertices[static_cast<std::size_t>(k)]);
        largest = std::max(largest, std::abs(residual(equation, corners)));
      }
      return largest;
    };
    EXPECT_LT(worst(), kUnitRounding);
    for (int k = 0; size > 3 && k < size; ++k) {
      points(2, k) = 0.1;
      EXPECT_GT(worst(), 0.02) << "size " << size << ", vertex " << k;
      points(2, k) = 0.0;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, FlatnessEquationAt, ::testing::ValuesIn(testing::seeds()));

TEST(FlatnessEquation, StaysFiniteOnDegenerateFaces) {
  const std::vector<int> quad{0, 1, 2, 3}, pentagon{0, 1, 2, 3, 4};
  const Positions point = Positions::Zero(3, 5);
  Positions line = Positions::Zero(3, 5);
  line.row(0) << 0, 1, 2, 3, 4;
  for (const Positions& points : {point, line}) {
    std::vector<FlatnessEquation> equations;
    append_flatness_equations(points, quad, equations);
    append_flatness_equations(points, pentagon, equations);
    ASSERT_EQ(equations.size(), 3u);
    for (const FlatnessEquation& equation : equations) EXPECT_TRUE(std::isfinite(equation.scale));
  }
}

/// ‖Cn − λ₁n‖ is zero for a smallest eigenvector, also where it is not unique.
void expect_smallest(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& guess) {
  const Eigen::Vector3d n = smallest_direction(covariance, guess);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const double size = std::max(covariance.trace(), 1e-300);
  EXPECT_NEAR(n.norm(), 1.0, kUnitRounding);
  EXPECT_NEAR(n.dot(covariance * n) / size, solver.eigenvalues()[0] / size, 1e-10);
  EXPECT_LT((covariance * n - solver.eigenvalues()[0] * n).norm() / size, 1e-9)
      << covariance << "\nguess " << guess.transpose();
}

class SmallestDirection : public ::testing::TestWithParam<unsigned> {};

TEST_P(SmallestDirection, AgreesWithTheDecompositionForAnyGuess) {
  const Eigen::Matrix3d basis =
      Eigen::AngleAxisd(1.1, random_points(GetParam(), 1).col(0).normalized()).toRotationMatrix();
  const std::vector<Eigen::Vector3d> spectra{
      {1, 2, 3},          {0, 1, 2},     {0, 1, 1}, {1, 1, 2},        {1, 1, 1},
      {0, 0, 1},          {1e-12, 1, 1}, {0, 0, 0}, {1, 1 + 1e-9, 2}, {1e-30, 2e-30, 3e-30},
      {1e20, 2e20, 2e20}, {0, 1e-9, 1}};
  for (const Eigen::Vector3d& values : spectra) {
    const Eigen::Matrix3d covariance = basis * values.asDiagonal() * basis.transpose();
    expect_smallest(covariance, Eigen::Vector3d::Zero());
    for (int k = 0; k < 3; ++k) expect_smallest(covariance, basis.col(k));
    const Eigen::Matrix3Xd guesses = random_points(GetParam() + 50, 4);
    for (int k = 0; k < 4; ++k) expect_smallest(covariance, guesses.col(k).normalized());
  }
}

TEST_P(SmallestDirection, IsRefinedFromANearbyGuess) {
  const Eigen::Matrix3Xd points = random_points(GetParam(), 6);
  const Eigen::Matrix3d covariance = points * points.transpose();
  const Eigen::Vector3d exact = smallest_direction(covariance, Eigen::Vector3d::Zero());
  const Eigen::Vector3d near =
      (exact + 0.01 * random_points(GetParam() + 9, 1).col(0)).normalized();
  const Eigen::Vector3d refined = smallest_direction(covariance, near);
  EXPECT_LT(std::min((refined - exact).norm(), (refined + exact).norm()), 1e-9);
  EXPECT_GT(refined.dot(near), 0.9) << "the sign follows the guess";
}

class PlaneProjection : public ::testing::TestWithParam<unsigned> {};

TEST_P(PlaneProjection, IsIdempotent) {
  for (const int size : {4, 5, 6, 9}) {
    Eigen::Matrix3Xd once = random_points(GetParam(), size);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    project_to_plane_centred(once, normal);
    EXPECT_LT((normal.transpose() * once).norm(), kUnitRounding);
    EXPECT_LT(once.rowwise().mean().norm(), kUnitRounding);
    Eigen::Matrix3Xd twice = once;
    Eigen::Vector3d again = normal;
    project_to_plane_centred(twice, again);
    EXPECT_LT((twice - once).norm(), kUnitRounding);
  }
}

/// (16): no other plane through the mean is nearer.
TEST_P(PlaneProjection, MovesLessThanTheProjectionToAnyOtherPlane) {
  Eigen::Matrix3Xd points = random_points(GetParam(), 6);
  points.colwise() -= points.rowwise().mean().eval();
  Eigen::Matrix3Xd nearest = points;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  project_to_plane_centred(nearest, normal);
  const double moved = (nearest - points).norm();
  const Eigen::Matrix3Xd others = random_points(GetParam() + 200, 50);
  for (int k = 0; k < 50; ++k) {
    EXPECT_LE(moved, (others.col(k).normalized().transpose() * points).norm() + kUnitRounding);
  }
}

TEST_P(PlaneProjection, TurnsWithItsPoints) {
  const Eigen::Matrix3Xd points = random_points(GetParam(), 5);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.0, random_points(GetParam() + 3, 1).col(0).normalized())
          .toRotationMatrix();
  Eigen::Matrix3Xd here = points, there = turn * points;
  Eigen::Vector3d first = Eigen::Vector3d::Zero(), second = Eigen::Vector3d::Zero();
  project_to_plane_centred(here, first);
  project_to_plane_centred(there, second);
  EXPECT_LT((turn * here - there).norm(), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SmallestDirection, ::testing::ValuesIn(testing::seeds()));
INSTANTIATE_TEST_SUITE_P(Seeds, PlaneProjection, ::testing::ValuesIn(testing::seeds()));

}  // namespace
}  // namespace planish
