// SPDX-License-Identifier: MIT
/// Multifrontal Cholesky of sparse symmetric matrices made of small square blocks.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "planish/mesh/adjacency.hpp"
#include "planish/numeric/executor.hpp"

namespace planish {

/// How the elimination order is found.
enum class EliminationOrder {
  kMinimumDegree,  ///< approximate minimum degree: any graph
  kGiven,          ///< nodes are eliminated in the order of their numbers
};

/// Where a block lives: entry (r, c) at values()[offset + r + c · stride].
struct BlockSlot {
  std::ptrdiff_t offset = -1;
  std::ptrdiff_t stride = 0;
};

/// A = L Lᵀ for a matrix of b × b blocks on the nodes of a graph. One analysis serves any number of
/// factorizations; values are written where the factor overwrites them, so nothing is copied.
///
///   analyze(graph, b);  set_zero();  values()[slot(i, j)…] += …;  factorize();  solve(x);
class SparseCholesky {
 public:
  /// @param graph symmetric adjacency without self loops; row i = neighbours of node i
  /// @param block_size b ≥ 1, the same for all nodes
  void analyze(const RaggedRows& graph, int block_size,
               EliminationOrder order = EliminationOrder::kMinimumDegree);

  [[nodiscard]] int node_count() const { return static_cast<int>(position_.size()); }
  [[nodiscard]] int block_size() const { return block_; }
  /// When `node` is eliminated. Only blocks (i, j) with position(i) ≥ position(j) are stored.
  [[nodiscard]] int position(int node) const { return position_[static_cast<std::size_t>(node)]; }
  /// The block (row, column), position(row) ≥ position(column); both must be neighbours or equal.
  /// On the diagonal only the lower triangle is read.
  [[nodiscard]] BlockSlot slot(int row, int column) const;

  void set_zero();
  [[nodiscard]] std::vector<double>& values() { return values_; }

  /// Overwrites the values with the factor. False if a pivot is not positive: the matrix is not
  /// positive definite, and the values are lost.
  [[nodiscard]] bool factorize();

  /// x ← A⁻¹ x for one right-hand side. @param x b · node_count, node-major in the caller's order
  /// @param executor for subtrees of the elimination tree, if they are large; the bits are the same
  void solve(Eigen::Ref<Eigen::VectorXd> x, Executor* executor = nullptr);
  /// x ← A⁻¹ x for three right-hand sides, block size 1: a column of x per node.
  /// @param x 3 × node_count
  void solve_coordinates(Eigen::Ref<Eigen::Matrix3Xd> x, Executor* executor = nullptr);

  /// Entries of L, for reports and benchmarks.
  [[nodiscard]] std::ptrdiff_t factor_size() const {
    return static_cast<std::ptrdiff_t>(values_.size());
  }

 private:
  /// Consecutive columns with one row structure: a dense panel of rows × columns.
  struct Supernode {
    int first = 0;                 ///< position of its first column
    int columns = 0;               ///< nodes
    int parent = -1;               ///< supernode that receives its update; −1 at a root
    std::ptrdiff_t values = 0;     ///< start of the panel, column-major
    std::ptrdiff_t row_begin = 0;  ///< rows below the diagonal block, in rows_
    std::ptrdiff_t row_end = 0;
    [[nodiscard]] int below() const { return static_cast<int>(row_end - row_begin); }
  };

  void order_nodes(const RaggedRows& graph, EliminationOrder order);
  [[nodiscard]] std::vector<int> elimination_tree(const RaggedRows& graph) const;
  [[nodiscard]] std::vector<int> column_counts(const RaggedRows& graph,
                                               const std::vector<int>& parents) const;
  void renumber_by_postorder(std::vector<int>& parents);
  void form_supernodes(const std::vector<int>& parents, const std::vector<int>& counts);
  void collect_rows(const RaggedRows& graph);
  void connect_fronts();
  void gather_children(const Supernode& node, std::size_t index);
  [[nodiscard]] bool eliminate(const Supernode& node);

  /// Consecutive supernodes with all that is eliminated into them: no other part has to do with
  /// their unknowns until all parts have told what they give to the unknowns behind them.
  struct SolvePart {
    int first = 0, last = 0;    ///< supernodes first … last − 1
    std::vector<double> below;  ///< work space: what one supernode gives
    std::vector<double> given;  ///< what all give to unknowns behind the part, in order
  };
  void divide();
  [[nodiscard]] int begin_of(int supernode) const;
  template <int kRight>
  void solve_in_parts(double* x, Executor* executor);
  template <int kRight>
  void eliminate_forward(const Supernode& node, int end, SolvePart& part);
  template <int kRight>
  void take_given(const SolvePart& part);
  template <int kRight>
  void substitute_back(const Supernode& node, SolvePart& part);

  int block_ = 1;
  std::vector<int> position_, node_at_;  ///< node → position and back
  std::vector<Supernode> supernodes_;
  std::vector<int> owner_;      ///< position → supernode
  std::vector<int> rows_;       ///< positions, ascending, all supernodes
  std::vector<int> in_parent_;  ///< same layout as rows_: index in the parent's front, in nodes
  std::vector<int> children_begin_, children_;
  std::vector<double> values_;
  std::vector<double> updates_;            ///< stack of update matrices
  std::vector<std::ptrdiff_t> update_at_;  ///< supernode → its place on the stack
  bool divided_ = false;
  std::vector<SolvePart> parts_;  ///< ascending, if divided_; between them is what they give to
  SolvePart rest_;                ///< work space for that
  std::vector<double> ordered_;   ///< x in the order of elimination
};

}  // namespace planish
