// SPDX-License-Identifier: MIT
/// The inverse of a factorized matrix some of whose rows came or went since: by Woodbury's
/// identity, with one solve for each of them, in place of another factorization. [LIM-2]
///
///   (K + μ Gᵀ Σ G)⁻¹ r = x − Y (Σ/μ + G Y)⁻¹ G x,   x = K⁻¹ r,   Y = K⁻¹ Gᵀ
///
/// with Σ = 1 where a row came and −1 where one went: it is positive definite exactly when the
/// small matrix has as many negative eigenvalues as rows went.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "engines/row_jacobian.hpp"

namespace planish {

class RowUpdate {
 public:
  /// x ← K⁻¹ x. @param x 3 × free
  using Inverse = std::function<void(Eigen::Matrix3Xd& x)>;

  /// Starts from a new factorization. @param active by row 0 or 1: those that are in K; empty: none
  void begin(const std::vector<char>& active);

  /// Goes from K to the matrix with these rows in it. Costs a solve for each row that was not asked
  /// for since begin().
  /// @returns false, and what was asked for last stands, where more than a few hundred differ or
  /// the matrix would not be positive definite
  [[nodiscard]] bool set(const std::vector<char>& active, double penalty, const RowJacobian& rows,
                         const Inverse& inverse);

  /// Takes K⁻¹ r to the inverse asked for of r. @param x 3 × free
  void apply(const RowJacobian& rows, Eigen::Matrix3Xd& x) const;

 private:
  struct Change {
    int row;
    bool came;
    int column;  ///< of columns_
  };

  [[nodiscard]] std::vector<Change> changes_to(const std::vector<char>& active) const;
  [[nodiscard]] int column_of(int row, const RowJacobian& rows, const Inverse& inverse);

  std::vector<char> factorized_;
  std::vector<int> rows_;                  ///< with a column
  std::vector<Eigen::Matrix3Xd> columns_;  ///< of Y, as rows_
  std::vector<Change> changes_;
  Eigen::LDLT<Eigen::MatrixXd> small_;  ///< Σ/μ + G Y
};

}  // namespace planish
