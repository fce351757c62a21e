// SPDX-License-Identifier: MIT
/// The solves of a SparseCholesky, in parts of its elimination tree that need not wait for each
/// other. Every sum has the order that it has in one pass over the supernodes.
#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <span>

#include "engines/sparse_cholesky.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

using FactorPanel = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
template <int kRight>
using RightSides = Eigen::Map<
    Eigen::Matrix<double, Eigen::Dynamic, kRight, kRight == 1 ? Eigen::ColMajor : Eigen::RowMajor>>;

double* work_space(std::vector<double>& values, std::ptrdiff_t count) {
  if (static_cast<std::ptrdiff_t>(values.size()) < count) values.resize(at(count));
  return values.data();
}

}  // namespace

/// Where the unknowns of a supernode begin; of the one after the last, their number.
int SparseCholesky::begin_of(int supernode) const {
  return at(supernode) < supernodes_.size() ? supernodes_[at(supernode)].first : node_count();
}

/// Subtrees of at most a share of the factor are parts, small neighbours together; supernodes of
/// larger ones are in none.
void SparseCholesky::divide() {
  constexpr double kShare = 0.25;   // smaller: more that waits for all parts; larger: uneven ones
  constexpr double kWorthIt = 3e4;  // entries of a factor that is quicker on one thread
  divided_ = true;
  parts_.clear();
  const auto total = static_cast<double>(values_.size());
  if (total < kWorthIt) return;
  const double most = kShare * total;
  std::vector<double> weight(supernodes_.size(), 0.0);
  for (std::size_t s = 0; s < weight.size(); ++s) {
    const Supernode& node = supernodes_[s];
    weight[s] +=
        static_cast<double>(node.columns) * (node.columns + node.below()) * block_ * block_;
    if (node.parent >= 0) weight[at(node.parent)] += weight[s];
  }
  double gathered = 0.0;
  int first = 0;
  for (std::size_t s = 0; s < weight.size(); ++s) {
    const int next = static_cast<int>(s) + 1;
    const bool inside = weight[s] <= most;
    const int parent = supernodes_[s].parent;
    const bool is_root = parent < 0 || !(weight[at(parent)] <= most);
    if (inside && !is_root) continue;
    if (inside) gathered += weight[s];
    const bool ends = !inside || gathered > 0.5 * most || at(next) == weight.size();
    if (!ends) continue;
    const int last = inside ? next : next - 1;
    if (last > first) parts_.push_back({first, last, {}, {}});
    first = next;
    gathered = 0.0;
  }
}

/// L⁻¹ of one supernode. @param end the unknown behind the part
template <int kRight>
void SparseCholesky::eliminate_forward(const Supernode& node, int end, SolvePart& part) {
  const auto bundle = static_cast<std::ptrdiff_t>(block_) * kRight;  // numbers per node
  const Eigen::Index height = static_cast<Eigen::Index>(node.columns + node.below()) * block_;
  const Eigen::Index pivot = static_cast<Eigen::Index>(node.columns) * block_;
  const FactorPanel panel(values_.data() + node.values, height, pivot,
                          Eigen::OuterStride<>(height));
  RightSides<kRight> own(ordered_.data() + node.first * bundle, pivot, kRight);
  const double* from = work_space(part.below, node.below() * bundle);
  RightSides<kRight> below(part.below.data(), height - pivot, kRight);
  panel.topRows(pivot).template triangularView<Eigen::Lower>().solveInPlace(own);
  below.noalias() = panel.bottomRows(height - pivot) * own;
  auto row = node.row_begin;
  for (; row < node.row_end && rows_[at(row)] < end; ++row, from += bundle) {
    double* const target = ordered_.data() + rows_[at(row)] * bundle;
    for (std::ptrdiff_t e = 0; e < bundle; ++e) target[e] -= from[e];
  }
  part.given.insert(part.given.end(), from, from + (node.row_end - row) * bundle);
}

template <int kRight>
void SparseCholesky::take_given(const SolvePart& part) {
  const auto bundle = static_cast<std::ptrdiff_t>(block_) * kRight;
  const int end = begin_of(part.last);
  const double* from = part.given.data();
  for (int s = part.first; s < part.last; ++s) {
    const Supernode& node = supernodes_[at(s)];
    const auto last = rows_.begin() + node.row_end;
    for (auto row = std::lower_bound(rows_.begin() + node.row_begin, last, end); row != last;
         ++row, from += bundle) {
      double* const target = ordered_.data() + *row * bundle;
      for (std::ptrdiff_t e = 0; e < bundle; ++e) target[e] -= from[e];
    }
  }
}

/// L⁻ᵀ of one supernode.
template <int kRight>
void SparseCholesky::substitute_back(const Supernode& node, SolvePart& part) {
  const auto bundle = static_cast<std::ptrdiff_t>(block_) * kRight;
  const Eigen::Index height = static_cast<Eigen::Index>(node.columns + node.below()) * block_;
  const Eigen::Index pivot = static_cast<Eigen::Index>(node.columns) * block_;
  const FactorPanel panel(values_.data() + node.values, height, pivot,
                          Eigen::OuterStride<>(height));
  RightSides<kRight> own(ordered_.data() + node.first * bundle, pivot, kRight);
  double* to = work_space(part.below, node.below() * bundle);
  const RightSides<kRight> below(to, height - pivot, kRight);
  for (auto row = node.row_begin; row < node.row_end; ++row) {
    to = std::copy_n(ordered_.data() + rows_[at(row)] * bundle, bundle, to);
  }
  own.noalias() -= panel.bottomRows(height - pivot).transpose() * below;
  panel.topRows(pivot).template triangularView<Eigen::Lower>().transpose().solveInPlace(own);
}

/// @param x node-major in the caller's order
template <int kRight>
void SparseCholesky::solve_in_parts(double* x, Executor* executor) {
  const auto bundle = static_cast<std::ptrdiff_t>(block_) * kRight;
  if (executor != nullptr && !divided_) divide();
  const std::span<SolvePart> parts(parts_.data(), executor != nullptr ? parts_.size() : 0);
  ordered_.resize(at(node_count() * bundle));
  const auto load = [&](int first, int last) {
    for (int k = begin_of(first); k < begin_of(last); ++k) {
      std::copy_n(x + node_at_[at(k)] * bundle, bundle, ordered_.data() + k * bundle);
    }
  };
  const auto store = [&](int first, int last) {
    for (int k = begin_of(first); k < begin_of(last); ++k) {
      std::copy_n(ordered_.data() + k * bundle, bundle, x + node_at_[at(k)] * bundle);
    }
  };
  const auto forward = [&](int first, int last, int end, SolvePart& part) {
    for (int s = first; s < last; ++s) eliminate_forward<kRight>(supernodes_[at(s)], end, part);
  };
  const auto back = [&](int first, int last, SolvePart& part) {
    for (int s = last; s > first; --s) substitute_back<kRight>(supernodes_[at(s - 1)], part);
  };
  const auto gaps = static_cast<int>(parts.size()) + 1;
  const auto gap_begin = [&](int gap) { return gap == 0 ? 0 : parts[at(gap - 1)].last; };
  const auto gap_end = [&](int gap) {
    return gap + 1 == gaps ? static_cast<int>(supernodes_.size()) : parts[at(gap)].first;
  };
  const auto on_parts = [&](const auto& task) {
    if (!parts.empty()) executor->run(gaps - 1, [&](int p) { task(parts[at(p)]); });
  };
  on_parts([&](SolvePart& part) {
    part.given.clear();
    load(part.first, part.last);
    forward(part.first, part.last, begin_of(part.last), part);
  });
  for (int gap = 0; gap < gaps; ++gap) load(gap_begin(gap), gap_end(gap));
  for (int gap = 0; gap < gaps; ++gap) {
    forward(gap_begin(gap), gap_end(gap), node_count(), rest_);
    if (gap + 1 < gaps) take_given<kRight>(parts[at(gap)]);
  }
  for (int gap = gaps; gap-- > 0;) back(gap_begin(gap), gap_end(gap), rest_);
  for (int gap = 0; gap < gaps; ++gap) store(gap_begin(gap), gap_end(gap));
  on_parts([&](SolvePart& part) {
    back(part.first, part.last, part);
    store(part.first, part.last);
  });
}

void SparseCholesky::solve(Eigen::Ref<Eigen::VectorXd> x, Executor* executor) {
  assert(x.size() == static_cast<Eigen::Index>(node_count()) * block_);
  solve_in_parts<1>(x.data(), executor);
}

void SparseCholesky::solve_coordinates(Eigen::Ref<Eigen::Matrix3Xd> x, Executor* executor) {
  assert(block_ == 1 && x.cols() == node_count() && x.outerStride() == 3);
  solve_in_parts<3>(x.data(), executor);
}

}  // namespace planish
