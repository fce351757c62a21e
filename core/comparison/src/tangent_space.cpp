// SPDX-License-Identifier: MIT
#include "tangent_space.hpp"

#include <vector>

#include "planish/numeric/index.hpp"

namespace planish::comparison {
namespace {

constexpr double kShift = 1e-9;

using Triplets = std::vector<Eigen::Triplet<double>>;

Triplets hessian_entries(const Patch& patch) {
  Triplets entries;
  const int n = patch.free_count;
  for (int v = 0; v < n; ++v) {
    for (int c = 0; c < 3; ++c) {
      entries.emplace_back(3 * v + c, 3 * v + c, patch.terms[at(v)].square_weight);
    }
  }
  patch.for_each_fairness_row([&](const FairnessRow& row) {
    for (std::size_t k = 0; k < row.vertices.size(); ++k) {
      for (std::size_t l = 0; l < row.vertices.size(); ++l) {
        const int v = row.vertices[k];
        const int w = row.vertices[l];
        if (v >= n || w >= n) continue;
        const double value = patch.fairness_weight * row.weights[k] * row.weights[l];
        for (int c = 0; c < 3; ++c) entries.emplace_back(3 * v + c, 3 * w + c, value);
      }
    }
  });
  return entries;
}

Triplets jacobian_entries(const Patch& patch) {
  Triplets entries;
  patch.equations.for_each([&]<class Row>(int e, const Row& row) {
    const RowPoints<Row::kArity> slopes = gradient(row, corners(patch, row));
    for (int k = 0; k < Row::kArity; ++k) {
      const int v = row.vertices[at(k)];
      if (v >= patch.free_count) continue;
      for (int c = 0; c < 3; ++c) entries.emplace_back(e, 3 * v + c, slopes(c, k));
    }
  });
  return entries;
}

}  // namespace

TangentSpace::TangentSpace(const Patch& patch) {
  const int unknowns = 3 * patch.free_count;
  const int equations = static_cast<int>(patch.equations.size());
  Triplets entries = hessian_entries(patch);
  hessian_.resize(unknowns, unknowns);
  hessian_.setFromTriplets(entries.begin(), entries.end());
  const Triplets slopes = jacobian_entries(patch);
  jacobian_.resize(equations, unknowns);
  jacobian_.setFromTriplets(slopes.begin(), slopes.end());
  for (int k = 0; k < unknowns; ++k) entries.emplace_back(k, k, kShift);
  for (const auto& slope : slopes) {
    entries.emplace_back(unknowns + slope.row(), slope.col(), slope.value());
  }
  for (int k = 0; k < equations; ++k) entries.emplace_back(unknowns + k, unknowns + k, -kShift);
  Eigen::SparseMatrix<double> matrix(unknowns + equations, unknowns + equations);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_.compute(matrix);  // reads the lower triangle
}

Eigen::VectorXd TangentSpace::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd full = Eigen::VectorXd::Zero(jacobian_.cols() + jacobian_.rows());
  full.head(right.size()) = right;
  return factor_.solve(full).head(right.size());
}

}  // namespace planish::comparison
