// SPDX-License-Identifier: MIT
/// The energies of the three problems: fairness operators E and the closeness norms.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Which operator E measures the smoothness of a displacement, (2).
enum class FairnessKind {
  kLaplacian,         ///< uniform Laplacian; along the boundary, one-dimensional [EN-1]
  kSecondDifference,  ///< second differences along edge polylines [EN-2]
  kThirdDifference,   ///< third differences along edge polylines [EN-3]
};

/// Which closeness term keeps an edit local.
enum class Sparsity {
  kL21,   ///< Σ‖d_i‖: few vertices move at all [HE-2]
  kL2,    ///< Σ‖d_i‖²: the classical term, for comparison (Fig. 2)
  kNone,  ///< no term: only fairness and constraints
};

/// Rows × n, row-major; the same operator acts on x, y and z.
using FairnessOperator = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// E for `mesh` in units of one edge. Polylines go straight through interior vertices of even
/// valence and along the boundary; at an interior vertex of odd valence, where no line goes
/// straight, the row is 2 (mean of the neighbours − vertex), which has the same scale.
[[nodiscard]] FairnessOperator fairness_operator(const Mesh& mesh, const Adjacency& adjacency,
                                                 FairnessKind kind);

/// How sharply a displacement bends at each vertex: the largest ‖(E d)_r‖ over the rows r that are
/// about the vertex, that is, have their largest coefficient there. In the unit of
/// `displacement` (3 × n); 0 where no row is. [EN-4]
[[nodiscard]] std::vector<double> bending(const FairnessOperator& fairness,
                                          const Positions& displacement);

}  // namespace planish
