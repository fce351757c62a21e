// SPDX-License-Identifier: MIT
/// The largest of many lengths, entries and weights; 0 of none.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "planish/problem/problem.hpp"

namespace planish {

[[nodiscard]] inline double longest_column(const Eigen::Matrix3Xd& columns) {
  return columns.cols() > 0 ? columns.colwise().norm().maxCoeff() : 0.0;
}

[[nodiscard]] inline double largest_entry(const Eigen::VectorXd& values) {
  return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.0;
}

/// The largest w/2: what a norm term pulls with at most.
[[nodiscard]] inline double largest_pull(const Patch& patch) {
  double largest = 0.0;
  for (const VertexTerm& term : patch.terms) largest = std::max(largest, 0.5 * term.norm_weight);
  return largest;
}

}  // namespace planish
