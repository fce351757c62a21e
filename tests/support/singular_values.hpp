// SPDX-License-Identifier: MIT
/// Singular values and vectors of dense matrices.
#pragma once

#include <Eigen/Core>
#include <Eigen/SVD>

namespace planish::testing {

/// Compiled in a file of its own: Eigen's takes the compiler a quarter of a minute wherever it is
/// used. `parts`: Eigen::ComputeThinU and its like.
[[nodiscard]] Eigen::JacobiSVD<Eigen::MatrixXd> singular_values(const Eigen::MatrixXd& matrix,
                                                                unsigned parts);

}  // namespace planish::testing
