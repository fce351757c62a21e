// SPDX-License-Identifier: MIT
/// What every kind of constraint must keep, whatever it is: where its rows hold, derivatives
/// against differences; a measure that is zero exactly there; residuals that are lengths. A new
/// kind is checked by being registered.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "planish/constraints/constraint_rows.hpp"
#include "support/scenes.hpp"

namespace planish::testing {

/// Rows of one element and the points they are on.
template <ConstraintKind Kind>
class ConstraintCheck {
 public:
  using Row = typename Kind::Row;
  static constexpr int kUnknowns = 3 * Row::kArity;
  using Flat = Eigen::Matrix<double, kUnknowns, 1>;
  using Square = Eigen::Matrix<double, kUnknowns, kUnknowns>;

  /// An uneven convex ring of `size` points, about kUneven away from round, and from flat unless
  /// the kind presumes flat faces.
  ConstraintCheck(int size, unsigned seed) : points_(3, size), element_(at(size)) {
    const Eigen::Matrix3Xd noise = random_points(seed, size);
    for (int k = 0; k < size; ++k) {
      const double angle = 2.0 * std::acos(-1.0) * k / size;
      points_.col(k) =
          Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0) + kUneven * noise.col(k);
    }
    if constexpr (requires { Kind::kPresumesFlat; }) points_.row(2).setConstant(0.5);
    if (Kind::kElement == Element::kVertex) points_.col(0) = Eigen::Vector3d(0.1, 0.0, 0.6);
    std::iota(element_.begin(), element_.end(), 0);
    Kind::append_rows(points_, element_, rows_);
  }

  [[nodiscard]] bool empty() const { return rows_.empty(); }

  /// Where the row holds, its gradient is its derivative. (Elsewhere a kind may leave out what a
  /// factor of the residual multiplies: a scale or a normal that it holds still.)
  void expect_gradients() {
    keep_rows();
    for (const Row& row : rows_) {
      const RowPoints<Row::kArity> here = corners(row);
      const RowPoints<Row::kArity> slope = gradient(row, here);
      EXPECT_GT(slope.norm(), 1e-3) << Kind::kName;
      for (int k = 0; k < kUnknowns; ++k) {
        const double ahead = residual(row, moved(here, k, kStep));
        const double behind = residual(row, moved(here, k, -kStep));
        EXPECT_NEAR(slope.data()[k], (ahead - behind) / (2 * kStep), 1e-7 * (1.0 + slope.norm()))
            << Kind::kName;
      }
    }
  }

  /// What Newton's method needs of the curvature: where the row holds, along directions that keep
  /// it, it is the derivative of the gradient.
  void expect_curvature() {
    keep_rows();
    for (const Row& row : rows_) {
      const RowPoints<Row::kArity> here = corners(row);
      Square differences;
      for (int k = 0; k < kUnknowns; ++k) {
        const RowPoints<Row::kArity> column =
            (gradient(row, moved(here, k, kStep)) - gradient(row, moved(here, k, -kStep))) /
            (2 * kStep);
        differences.col(k) = Eigen::Map<const Flat>(column.data());
      }
      const RowPoints<Row::kArity> slope = gradient(row, here);
      const Flat normal = Eigen::Map<const Flat>(slope.data()).normalized();
      const Square along = Square::Identity() - normal * normal.transpose();
      const Square error = along * (dense(hessian(row, here)) - differences) * along;
      EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-6 * (1.0 + differences.norm())) << Kind::kName;
    }
  }

  /// Where every row holds the measure is rounding; where one does not, it is not.
  void expect_measure() {
    EXPECT_EQ(worst() > 1e-3, Kind::measure(points_, element_) > 1e-3) << Kind::kName;
    keep_rows();
    EXPECT_LT(Kind::measure(points_, element_), 1e-6) << Kind::kName;
  }

  /// A residual is a length: it scales with the points that its rows were made on.
  void expect_scaling() const {
    constexpr double kScale = 1000.0;
    const Positions large = kScale * points_;
    std::vector<Row> rows;
    Kind::append_rows(large, element_, rows);
    ASSERT_EQ(rows.size(), rows_.size());
    for (std::size_t e = 0; e < rows.size(); ++e) {
      const double small = residual(rows_[e], corners(rows_[e]));
      const double scaled = residual(rows[e], RowPoints<Row::kArity>(kScale * corners(rows_[e])));
      EXPECT_NEAR(scaled, kScale * small, 1e-9 * kScale) << Kind::kName;
    }
  }

 private:
  static constexpr double kStep = 1e-5;
  /// Planes about a vertex turn by more than points of a panel move.
  static constexpr double kUneven = Kind::kElement == Element::kVertex ? 0.05 : 0.2;
  static constexpr double kLongest = 0.1;

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  [[nodiscard]] RowPoints<Row::kArity> corners(const Row& row) const {
    RowPoints<Row::kArity> result;
    for (int k = 0; k < Row::kArity; ++k) result.col(k) = points_.col(row.vertices[at(k)]);
    return result;
  }

  static RowPoints<Row::kArity> moved(RowPoints<Row::kArity> points, int coordinate, double by) {
    points.data()[coordinate] += by;
    return points;
  }

  static Square dense(const CurvatureBlocks<Row::kArity, Row::kCurvedDiagonal>& blocks) {
    Square result = Square::Zero();
    for (int k = 0; k < Row::kArity; ++k) {
      for (int l = 0; l < k; ++l) {
        result.template block<3, 3>(3 * k, 3 * l) = blocks[block_index<Row>(k, l)];
        result.template block<3, 3>(3 * l, 3 * k) = blocks[block_index<Row>(k, l)].transpose();
      }
      if constexpr (Row::kCurvedDiagonal) {
        result.template block<3, 3>(3 * k, 3 * k) = blocks[block_index<Row>(k, k)];
      }
    }
    return result;
  }

  [[nodiscard]] double worst() const {
    double largest = 0.0;
    for (const Row& row : rows_) {
      const double value = residual(row, corners(row));
      const double broken = Kind::kSense == Sense::kZero ? std::abs(value) : -value;
      largest = std::max(largest, broken);
    }
    return largest;
  }

  /// Moves the points to where all rows are zero, by minimum-norm Newton steps.
  void keep_rows() {
    const auto count = static_cast<Eigen::Index>(rows_.size());
    for (int step = 0; step < 50; ++step) {
      Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(count, points_.size());
      Eigen::VectorXd values(count);
      for (Eigen::Index e = 0; e < count; ++e) {
        const Row& row = rows_[at(static_cast<int>(e))];
        const RowPoints<Row::kArity> slope = gradient(row, corners(row));
        values[e] = residual(row, corners(row));
        for (int k = 0; k < Row::kArity; ++k) {
          jacobian.block<1, 3>(e, 3 * row.vertices[at(k)]) += slope.col(k).transpose();
        }
      }
      if (values.cwiseAbs().maxCoeff() < 1e-14) break;
      Eigen::VectorXd delta = jacobian.completeOrthogonalDecomposition().solve(-values);
      delta *= std::min(1.0, kLongest / delta.norm());  // to a state near the first one
      points_ += Eigen::Map<const Positions>(delta.data(), 3, points_.cols());
    }
    ASSERT_LT(worst(), 1e-11) << Kind::kName << ": the rows could not be met";
  }

  Positions points_;
  std::vector<int> element_;
  std::vector<Row> rows_;
};

/// All checks, over random elements of several sizes.
template <ConstraintKind Kind>
void expect_sound_kind() {
  int checked = 0;
  for (int size = 3; size <= 8; ++size) {
    for (const unsigned seed : seeds()) {
      ConstraintCheck<Kind> check(size, seed + 100 * static_cast<unsigned>(size));
      if (check.empty()) continue;
      ++checked;
      check.expect_scaling();
      check.expect_measure();  // keeps the rows from here on
      check.expect_gradients();
      check.expect_curvature();
    }
  }
  EXPECT_GT(checked, 0) << Kind::kName << " has no rows on any polygon";
}

}  // namespace planish::testing
