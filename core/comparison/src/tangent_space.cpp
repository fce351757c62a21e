// SPDX-License-Identifier: MIT
#include "tangent_space.hpp"

#include <vector>

#include "planish/index.hpp"

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
  for (int r = 0; r < patch.fairness_vertices.size(); ++r) {
    const auto row = patch.fairness_vertices[r];
    const double* const values =
        patch.fairness_values.data() + patch.fairness_vertices.offsets[at(r)];
    for (std::size_t k = 0; k < row.size(); ++k) {
      for (std::size_t l = 0; l < row.size(); ++l) {
        if (row[k] >= n || row[l] >= n) continue;
        const double value = patch.fairness_weight * values[k] * values[l];
        for (int c = 0; c < 3; ++c) entries.emplace_back(3 * row[k] + c, 3 * row[l] + c, value);
      }
    }
  }
  return entries;
}

Triplets jacobian_entries(const Patch& patch) {
  Triplets entries;
  for (std::size_t e = 0; e < patch.equations.size(); ++e) {
    const FlatnessEquation& equation = patch.equations[e];
    const FourPoints slopes = gradient(equation, corners(patch, equation));
    for (int k = 0; k < 4; ++k) {
      const int v = equation.vertices[at(k)];
      if (v >= patch.free_count) continue;
      for (int c = 0; c < 3; ++c)
        entries.emplace_back(static_cast<int>(e), 3 * v + c, slopes(c, k));
    }
  }
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
