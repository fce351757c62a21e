// SPDX-License-Identifier: MIT
#include "support/singular_values.hpp"

namespace planish::testing {

Eigen::JacobiSVD<Eigen::MatrixXd> singular_values(const Eigen::MatrixXd& matrix, unsigned parts) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix, parts);
}

}  // namespace planish::testing
