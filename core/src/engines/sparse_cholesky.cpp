// SPDX-License-Identifier: MIT
#include "engines/sparse_cholesky.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <numeric>
#include <type_traits>

#include "engines/elimination_order.hpp"
#include "engines/panel_kernels.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

using Panel = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// Adds one column of an update: blocks first ≤ k < last of `from` to where map[k] says in `to`.
/// @param block their size
template <class Size>
void add_blocks(const double* from, const int* map, int first, int last, Size block, double* to) {
  for (int k = first; k < last; ++k) {
    double* const target = to + static_cast<std::ptrdiff_t>(map[k]) * block;
    const double* const source = from + static_cast<std::ptrdiff_t>(k) * block;
    for (int r = 0; r < block; ++r) target[r] += source[r];
  }
}

}  // namespace

void SparseCholesky::analyze(const RaggedRows& graph, int block_size, EliminationOrder order) {
  assert(block_size >= 1);
  block_ = block_size;
  divided_ = false;
  order_nodes(graph, order);
  std::vector<int> parents = elimination_tree(graph);
  renumber_by_postorder(parents);
  form_supernodes(parents, column_counts(graph, parents));
  collect_rows(graph);
  connect_fronts();
}

void SparseCholesky::order_nodes(const RaggedRows& graph, EliminationOrder order) {
  const int n = graph.size();
  if (order == EliminationOrder::kMinimumDegree && n > 0) {
    node_at_ = minimum_degree(graph);
  } else {
    node_at_.resize(at(n));
    std::iota(node_at_.begin(), node_at_.end(), 0);
  }
  position_.resize(at(n));
  for (int k = 0; k < n; ++k) position_[at(node_at_[at(k)])] = k;
}

/// Liu's algorithm with path compression, on positions.
std::vector<int> SparseCholesky::elimination_tree(const RaggedRows& graph) const {
  const int n = node_count();
  std::vector<int> parents(at(n), -1);
  std::vector<int> ancestors(at(n), -1);
  for (int j = 0; j < n; ++j) {
    for (const int neighbour : graph[node_at_[at(j)]]) {
      for (int i = position_[at(neighbour)]; i >= 0 && i < j;) {
        const int next = ancestors[at(i)];
        ancestors[at(i)] = j;
        if (next < 0) parents[at(i)] = j;
        i = next < 0 ? -1 : next;
      }
    }
  }
  return parents;
}

void SparseCholesky::renumber_by_postorder(std::vector<int>& parents) {
  const std::vector<int> order = postorder(parents);
  const int n = node_count();
  std::vector<int> rank(at(n));
  for (int k = 0; k < n; ++k) rank[at(order[at(k)])] = k;
  std::vector<int> nodes(at(n));
  std::vector<int> renumbered(at(n), -1);
  for (int k = 0; k < n; ++k) {
    nodes[at(k)] = node_at_[at(order[at(k)])];
    const int parent = parents[at(order[at(k)])];
    renumbered[at(k)] = parent < 0 ? -1 : rank[at(parent)];
  }
  node_at_ = std::move(nodes);
  parents = std::move(renumbered);
  for (int k = 0; k < n; ++k) position_[at(node_at_[at(k)])] = k;
}

/// Entries of each column of L, by walking the row subtrees.
std::vector<int> SparseCholesky::column_counts(const RaggedRows& graph,
                                               const std::vector<int>& parents) const {
  const int n = node_count();
  std::vector<int> counts(at(n), 1);
  std::vector<int> mark(at(n), -1);
  for (int row = 0; row < n; ++row) {
    mark[at(row)] = row;
    for (const int neighbour : graph[node_at_[at(row)]]) {
      for (int j = position_[at(neighbour)]; j >= 0 && j < row && mark[at(j)] != row;
           j = parents[at(j)]) {
        mark[at(j)] = row;
        ++counts[at(j)];
      }
    }
  }
  return counts;
}

void SparseCholesky::form_supernodes(const std::vector<int>& parents,
                                     const std::vector<int>& counts) {
  // Merging a chain of small columns costs some stored zeros and saves fronts.
  constexpr double kZeroShare = 0.25;
  constexpr int kSmallFront = 24;  // scalar columns that are always worth merging
  const int n = node_count();
  supernodes_.clear();
  owner_.assign(at(n), -1);
  std::ptrdiff_t dense = 0;
  std::ptrdiff_t stored = 0;
  for (int j = 0; j < n; ++j) {
    bool merge = false;
    if (!supernodes_.empty() && parents[at(j - 1)] == j) {
      const Supernode& last = supernodes_.back();
      // If joined, every column of the chain reaches as far as column j does.
      const std::ptrdiff_t width = last.columns + 1;
      const std::ptrdiff_t height = width - 1 + counts[at(j)];
      const std::ptrdiff_t joined_dense = width * height - width * (width - 1) / 2;
      const std::ptrdiff_t joined_stored = stored + counts[at(j)];
      const auto zeros = static_cast<double>(joined_dense - joined_stored);
      merge = zeros <= kZeroShare * static_cast<double>(joined_dense) ||
              (width * block_ <= kSmallFront && zeros <= 0.5 * static_cast<double>(joined_dense));
      if (counts[at(j - 1)] == counts[at(j)] + 1) merge = true;
      if (merge) {
        ++supernodes_.back().columns;
        dense = joined_dense;
        stored = joined_stored;
      }
    }
    if (!merge) {
      Supernode fresh;
      fresh.first = j;
      fresh.columns = 1;
      supernodes_.push_back(fresh);
      dense = counts[at(j)];
      stored = dense;
    }
    owner_[at(j)] = static_cast<int>(supernodes_.size()) - 1;
  }
}

/// Row structure of each supernode: its own entries and what its children pass up.
void SparseCholesky::collect_rows(const RaggedRows& graph) {
  const auto count = supernodes_.size();
  std::vector<std::vector<int>> passed(count);
  std::vector<int> mark(at(node_count()), -1);
  rows_.clear();
  std::ptrdiff_t values = 0;
  std::vector<int> found;
  for (std::size_t s = 0; s < count; ++s) {
    Supernode& node = supernodes_[s];
    const int end = node.first + node.columns;
    found.clear();
    const auto add = [&](int row) {
      if (row < end || mark[at(row)] == static_cast<int>(s)) return;
      mark[at(row)] = static_cast<int>(s);
      found.push_back(row);
    };
    for (int j = node.first; j < end; ++j) {
      for (const int neighbour : graph[node_at_[at(j)]]) add(position_[at(neighbour)]);
    }
    for (const int child : passed[s]) {
      const Supernode& below = supernodes_[at(child)];
      for (auto k = below.row_begin; k < below.row_end; ++k) {
        add(rows_[static_cast<std::size_t>(k)]);
      }
    }
    std::sort(found.begin(), found.end());
    node.row_begin = static_cast<std::ptrdiff_t>(rows_.size());
    rows_.insert(rows_.end(), found.begin(), found.end());
    node.row_end = static_cast<std::ptrdiff_t>(rows_.size());
    node.values = values;
    const std::ptrdiff_t height = (node.columns + node.below()) * block_;
    values += height * node.columns * block_;
    node.parent = found.empty() ? -1 : owner_[at(found.front())];
    if (node.parent >= 0) passed[at(node.parent)].push_back(static_cast<int>(s));
  }
  values_.assign(static_cast<std::size_t>(values), 0.0);
  children_begin_.assign(1, 0);
  children_.clear();
  for (const auto& list : passed) {
    children_.insert(children_.end(), list.begin(), list.end());
    children_begin_.push_back(static_cast<int>(children_.size()));
  }
}

void SparseCholesky::connect_fronts() {
  in_parent_.assign(rows_.size(), 0);
  update_at_.assign(supernodes_.size(), 0);
  std::ptrdiff_t top = 0;
  std::ptrdiff_t deepest = 0;
  for (std::size_t s = 0; s < supernodes_.size(); ++s) {
    const Supernode& node = supernodes_[s];
    // Children lie on top of the stack; this update replaces them once they are gathered, so it
    // is built above them and then moved down (see gather_children).
    const std::ptrdiff_t side = static_cast<std::ptrdiff_t>(node.below()) * block_;
    deepest = std::max(deepest, top + side * side);
    for (int c = children_begin_[s]; c < children_begin_[s + 1]; ++c) {
      const Supernode& child = supernodes_[at(children_[at(c)])];
      const std::ptrdiff_t child_side = static_cast<std::ptrdiff_t>(child.below()) * block_;
      top -= child_side * child_side;
    }
    update_at_[s] = top;
    top += side * side;
    if (node.parent < 0) continue;
    const Supernode& parent = supernodes_[at(node.parent)];
    auto cursor = parent.row_begin;
    for (auto k = node.row_begin; k < node.row_end; ++k) {
      const int row = rows_[static_cast<std::size_t>(k)];
      int index = row - parent.first;
      if (index >= parent.columns) {
        while (rows_[static_cast<std::size_t>(cursor)] != row) ++cursor;
        index = parent.columns + static_cast<int>(cursor - parent.row_begin);
      }
      in_parent_[static_cast<std::size_t>(k)] = index;
    }
  }
  updates_.assign(static_cast<std::size_t>(deepest), 0.0);
}

BlockSlot SparseCholesky::slot(int row, int column) const {
  const int i = position_[at(row)];
  const int j = position_[at(column)];
  assert(i >= j);
  const Supernode& node = supernodes_[at(owner_[at(j)])];
  int index = i - node.first;
  if (index >= node.columns) {
    const auto begin = rows_.begin() + node.row_begin;
    const auto found = std::lower_bound(begin, rows_.begin() + node.row_end, i);
    assert(found != rows_.begin() + node.row_end && *found == i);
    index = node.columns + static_cast<int>(found - begin);
  }
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(node.columns + node.below()) * block_;
  const std::ptrdiff_t offset = node.values + static_cast<std::ptrdiff_t>(index) * block_ +
                                static_cast<std::ptrdiff_t>(j - node.first) * block_ * stride;
  return {offset, stride};
}

void SparseCholesky::set_zero() { std::fill(values_.begin(), values_.end(), 0.0); }

/// Adds the children's updates to the panel and starts this front's own update matrix.
void SparseCholesky::gather_children(const Supernode& node, std::size_t index) {
  const std::ptrdiff_t height = static_cast<std::ptrdiff_t>(node.columns + node.below()) * block_;
  const std::ptrdiff_t side = static_cast<std::ptrdiff_t>(node.below()) * block_;
  const std::ptrdiff_t pivot = static_cast<std::ptrdiff_t>(node.columns) * block_;
  double* const panel = values_.data() + node.values;
  std::ptrdiff_t top = update_at_[index];
  for (int c = children_begin_[index]; c < children_begin_[index + 1]; ++c) {
    const Supernode& child = supernodes_[at(children_[at(c)])];
    const std::ptrdiff_t child_side = static_cast<std::ptrdiff_t>(child.below()) * block_;
    top = std::max(top, update_at_[at(children_[at(c)])] + child_side * child_side);
  }
  double* const own = updates_.data() + top;
  for (std::ptrdiff_t j = 0; j < side; ++j) {  // lower triangles only, here and below
    std::fill(own + j * side + j, own + (j + 1) * side, 0.0);
  }
  for (int c = children_begin_[index]; c < children_begin_[index + 1]; ++c) {
    const Supernode& child = supernodes_[at(children_[at(c)])];
    const int below = child.below();
    const std::ptrdiff_t child_side = static_cast<std::ptrdiff_t>(below) * block_;
    const double* const update = updates_.data() + update_at_[at(children_[at(c)])];
    const int* const map = in_parent_.data() + child.row_begin;
    for (int cj = 0; cj < below; ++cj) {
      for (int bc = 0; bc < block_; ++bc) {
        const std::ptrdiff_t column = static_cast<std::ptrdiff_t>(map[cj]) * block_ + bc;
        const double* const from =
            update + (static_cast<std::ptrdiff_t>(cj) * block_ + bc) * child_side;
        double* const to =
            column < pivot ? panel + column * height : own + (column - pivot) * side - pivot;
        if (block_ == 3) {
          add_blocks(from, map, cj, below, std::integral_constant<int, 3>{}, to);
        } else {
          add_blocks(from, map, cj, below, block_, to);
        }
      }
    }
  }
  if (top != update_at_[index]) {
    double* const down = updates_.data() + update_at_[index];
    for (std::ptrdiff_t j = 0; j < side; ++j) {
      std::copy(own + j * side + j, own + (j + 1) * side, down + j * side + j);
    }
  }
}

bool SparseCholesky::eliminate(const Supernode& node) {
  const Eigen::Index height = static_cast<Eigen::Index>(node.columns + node.below()) * block_;
  const Eigen::Index pivot = static_cast<Eigen::Index>(node.columns) * block_;
  const Eigen::Index side = height - pivot;
  if (block_ == 3) {
    if (!eliminate_panel(values_.data() + node.values, height, pivot)) return false;
    const auto at_stack = update_at_[static_cast<std::size_t>(&node - supernodes_.data())];
    update_front(values_.data() + node.values, height, pivot, updates_.data() + at_stack);
    return true;
  }
  Panel panel(values_.data() + node.values, height, pivot, Eigen::OuterStride<>(height));
  Eigen::Ref<Eigen::MatrixXd> diagonal = panel.topRows(pivot);
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(diagonal);
  if (factor.info() != Eigen::Success) return false;
  if (!(diagonal.diagonal().array() > 0.0).all()) return false;  // LLT lets NaN through
  if (side == 0) return true;
  auto below = panel.bottomRows(side);
  diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
  const auto index = static_cast<std::size_t>(&node - supernodes_.data());
  Panel update(updates_.data() + update_at_[index], side, side, Eigen::OuterStride<>(side));
  update.selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0);
  return true;
}

bool SparseCholesky::factorize() {
  for (std::size_t s = 0; s < supernodes_.size(); ++s) {
    gather_children(supernodes_[s], s);
    if (!eliminate(supernodes_[s])) return false;
  }
  return true;
}

}  // namespace planish
