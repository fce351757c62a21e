// SPDX-License-Identifier: MIT
#include "engines/patch_system.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engines/coupling_graph.hpp"
#include "engines/weighted_barrier.hpp"
#include "planish/numeric/index.hpp"

namespace planish {

namespace {

/// Adds a 3 × 3 block to the panels.
void add_block(std::vector<double>& values, const BlockSlot& slot, const Eigen::Matrix3d& block) {
  double* const target = values.data() + slot.offset;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) target[r + c * slot.stride] += block(r, c);
  }
}

void add_diagonal(std::vector<double>& values, const BlockSlot& slot, double value) {
  for (int c = 0; c < 3; ++c) values[at(slot.offset + c + c * slot.stride)] += value;
}

/// Adds λ ∂²c/∂(corner k)∂(corner l) to `sum`.
template <ConstraintRow Row>
void add_curvature(const CurvatureBlocks<Row::kArity, Row::kCurvedDiagonal>& blocks, double lambda,
                   int k, int l, Eigen::Matrix3d& sum) {
  if (k > l) {
    sum += lambda * blocks[block_index<Row>(k, l)];
  } else if (k < l) {
    sum += lambda * blocks[block_index<Row>(l, k)].transpose();
  } else if constexpr (Row::kCurvedDiagonal) {
    sum += lambda * blocks[block_index<Row>(k, k)];
  }
}

/// Block (k, l) of t (B'' ∇g ∇gᵀ + B' ∇²g).
template <class Row, class Gradient, class Hessian>
Eigen::Matrix3d block_of(const Row& /*row*/, const Barrier& barrier, const Gradient& g,
                         const Hessian& hessian, int k, int l) {
  const Eigen::Matrix3d own = hessian.template block<3, 3>(3 * k, 3 * l);
  return barrier.curvature * g.col(k) * g.col(l).transpose() + barrier.slope * own;
}

/// Block (k, l) of a corner, from its vertices in their order around the panel.
Eigen::Matrix3d block_of(const CornerShape& corner, const Barrier& barrier, const RowPoints<3>& g,
                         const CurvatureBlocks<3, false>& hessian, int k, int l) {
  if (l == (k + 2) % 3) return block_of(corner, barrier, g, hessian, l, k).transpose();
  Eigen::Matrix3d block = barrier.curvature * g.col(k) * g.col(l).transpose();
  add_curvature<CornerShape>(hessian, barrier.slope, k, l, block);
  return block;
}

}  // namespace

void update_norm_duals(const Eigen::Matrix3Xd& before, double smoothing, PatchState& state) {
  for (Eigen::Index k = 0; k < before.cols(); ++k) {
    const Eigen::Vector3d d = before.col(k);
    const Eigen::Vector3d w = state.norm_dual.col(k);
    const double s = std::sqrt(d.squaredNorm() + smoothing * smoothing);
    const Eigen::Vector3d moved = state.displacement.col(k) - d;
    const Eigen::Vector3d next = (d + moved - w * (d.dot(moved) / s)) / s;
    state.norm_dual.col(k) = next / std::max(1.0, next.norm());
  }
}

void PatchSystem::attach(const Patch& patch, Constraints constraints) {
  patch_ = &patch;
  constraints_ = constraints;
  lagrangian_.attach(patch, constraints);
  analyze(graph_of(patch));
  place_rows(patch_->equations, equation_places_);
  place_rows(patch_->inequalities, inequality_places_);
  fill_constant_part();
  jacobian_.attach(patch);
  has_limits_ = false;
  patch.inequalities.for_each(
      [&](int, const auto& row) { has_limits_ = has_limits_ || has_multiplier(row); });
  if (has_limits_) limit_jacobian_.attach(patch, patch.inequalities);
  active_.clear();
}

RaggedRows PatchSystem::graph_of(const Patch& patch) {
  Cliques cliques;
  patch.equations.for_each([&](int, const auto& row) { cliques.add(row.vertices); });
  patch.inequalities.for_each([&](int, const auto& row) { cliques.add(row.vertices); });
  for (int r = 0; r < patch.fairness_vertices.size(); ++r) {
    cliques.add(patch.fairness_vertices[r]);
  }
  return cliques.graph(patch.free_count);
}

/// Frames of a drag and runs within a reach cut the same patch again and again: its analysis
/// stands for as long as the graph is the same.
void PatchSystem::analyze(RaggedRows graph) {
  if (graph == graph_) return;
  graph_ = std::move(graph);
  cholesky_.analyze(graph_, 3);
  const int nodes = graph_.size();
  diagonal_.resize(at(nodes));
  for (int v = 0; v < nodes; ++v) diagonal_[at(v)] = cholesky_.slot(v, v);
  place_edges();
}

/// Places one slot per edge of the graph: equations and fairness rows then look edges up by row.
void PatchSystem::place_edges() {
  edge_slots_.assign(graph_.values.size(), {});
  for (int v = 0; v < graph_.size(); ++v) {
    const auto row = graph_[v];
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (cholesky_.position(v) < cholesky_.position(row[k])) continue;
      edge_slots_[at(graph_.offsets[at(v)]) + k] = cholesky_.slot(v, row[k]);
    }
  }
}

/// Index of (row, column) in graph_.values.
std::size_t PatchSystem::edge(int row, int column) const {
  const auto around = graph_[row];
  const auto found = std::lower_bound(around.begin(), around.end(), column);
  assert(found != around.end() && *found == column);
  return at(graph_.offsets[at(row)]) + static_cast<std::size_t>(found - around.begin());
}

/// Finds where the blocks of each row of a batch go.
template <class Batches>
void PatchSystem::place_rows(const Batches& rows, RowPlaces& places) const {
  places.free.clear();
  places.order.clear();
  places.slots.clear();
  rows.for_each([&](int, const auto& row) { place_row(row.vertices, places); });
}

void PatchSystem::place_row(std::span<const int> vertices, RowPlaces& places) const {
  const std::size_t first = places.order.size();
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (vertices[k] < patch_->free_count) places.order.push_back(static_cast<int>(k));
  }
  const auto order = places.order.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(order, places.order.end(), [&](int a, int b) {
    return cholesky_.position(vertices[at(a)]) > cholesky_.position(vertices[at(b)]);
  });
  places.free.push_back(static_cast<int>(places.order.size() - first));
  for (auto late = order; late != places.order.end(); ++late) {
    const int column = vertices[at(*late)];
    for (auto early = order; early != late; ++early) {
      // *early is eliminated later than *late: it is the row. Where a row names a vertex twice, its
      // blocks are zero.
      const int later = vertices[at(*early)];
      places.slots.push_back(later == column ? diagonal_[at(column)]
                                             : edge_slots_[edge(later, column)]);
    }
    places.slots.push_back(diagonal_[at(column)]);
  }
}

void PatchSystem::fill_constant_part() {
  const int n = patch_->free_count;
  std::vector<double> diagonal(at(n));
  for (int v = 0; v < n; ++v) diagonal[at(v)] = patch_->terms[at(v)].square_weight;
  edge_weights_.assign(graph_.values.size(), 0.0);
  patch_->for_each_fairness_row([&](const FairnessRow& row) {
    for (std::size_t k = 0; k < row.vertices.size(); ++k) {
      const int v = row.vertices[k];
      if (v >= n) continue;
      const double weight = patch_->fairness_weight * row.weights[k];
      diagonal[at(v)] += weight * row.weights[k];
      for (std::size_t l = 0; l < k; ++l) {
        const int w = row.vertices[l];
        if (w >= n) continue;
        const bool later = cholesky_.position(v) > cholesky_.position(w);
        edge_weights_[later ? edge(v, w) : edge(w, v)] += weight * row.weights[l];
      }
    }
  });
  cholesky_.set_zero();
  std::vector<double>& values = cholesky_.values();
  for (int v = 0; v < n; ++v) add_diagonal(values, diagonal_[at(v)], diagonal[at(v)]);
  for (std::size_t k = 0; k < edge_weights_.size(); ++k) {
    if (edge_weights_[k] != 0.0) add_diagonal(values, edge_slots_[k], edge_weights_[k]);
  }
  constant_ = values;
}

void PatchSystem::add_equations(const PatchState& state, double penalty) {
  std::vector<double>& values = cholesky_.values();
  const int* order = equation_places_.order.data();
  const BlockSlot* slot = equation_places_.slots.data();
  patch_->equations.for_each([&]<class Row>(int e, const Row& row) {
    const RowPoints<Row::kArity> points = lagrangian_.points_of(row, state.displacement);
    const RowPoints<Row::kArity> g = gradient(row, points);
    const auto curvature = hessian(row, points);
    jacobian_.set(e, g);
    const double lambda = constraints_ == Constraints::kExact ? state.multipliers[e] : 0.0;
    const int free = equation_places_.free[at(e)];
    for (int late = 0; late < free; ++late) {
      for (int early = 0; early <= late; ++early) {
        Eigen::Matrix3d sum = (penalty * g.col(order[early])) * g.col(order[late]).transpose();
        add_curvature<Row>(curvature, lambda, order[early], order[late], sum);
        add_block(values, *slot++, sum);
      }
    }
    order += free;
  });
  jacobian_.slide();
}

void PatchSystem::evaluate_limits(const Eigen::Matrix3Xd& displacement) {
  patch_->inequalities.for_each([&](int number, const auto& row) {
    if (!has_multiplier(row)) return;
    const auto g = gradient(row, corners_at(*patch_, displacement, row));
    limit_jacobian_.set(number, row.scale.slope * g);
  });
  limit_jacobian_.slide();
}

/// t (B'' ∇g ∇gᵀ + B' ∇²g) of the barriers that act, μ ∇s ∇sᵀ − z ∇²s of the rows that are active.
void PatchSystem::add_inequalities(const PatchState& state) {
  std::vector<double>& values = cholesky_.values();
  const int* order = inequality_places_.order.data();
  const BlockSlot* slot = inequality_places_.slots.data();
  patch_->inequalities.for_each([&](int number, const auto& row) {
    const int free = inequality_places_.free[at(number)];
    const auto points = corners_at(*patch_, state.displacement, row);
    Barrier barrier;
    if (!has_multiplier(row)) {
      barrier = weighted_barrier(*patch_, row, value(row, points));
    } else if (!active_.empty() && active_[at(number)] != 0) {
      const double by_value = row.scale.slope;
      barrier = {0.0, -state.limit_multipliers[number] * by_value,
                 limit_penalty_ * by_value * by_value};
    }
    if (barrier.curvature == 0.0) {
      slot += free * (free + 1) / 2;
    } else {
      const auto g = gradient(row, points);
      const auto curvature = hessian(row, points);
      for (int late = 0; late < free; ++late) {
        for (int early = 0; early <= late; ++early) {
          add_block(values, *slot++,
                    block_of(row, barrier, g, curvature, order[early], order[late]));
        }
      }
    }
    order += free;
  });
}

void PatchSystem::add_norms(const PatchState& state, double smoothing, double shift) {
  std::vector<double>& values = cholesky_.values();
  for (int v = 0; v < patch_->free_count; ++v) {
    const double weight = 0.5 * patch_->terms[at(v)].norm_weight;
    if (shift > 0.0) add_diagonal(values, diagonal_[at(v)], shift);
    if (weight <= 0.0) continue;
    const Eigen::Vector3d d = state.displacement.col(v);
    const Eigen::Vector3d w = state.norm_dual.col(v);
    const double s = std::sqrt(d.squaredNorm() + smoothing * smoothing);
    const Eigen::Matrix3d outer = (0.5 / s) * (w * d.transpose() + d * w.transpose());
    add_block(values, diagonal_[at(v)], (weight / s) * (Eigen::Matrix3d::Identity() - outer));
  }
}

/// H ← P H P + I − P: what a vertex with supports cannot do neither bends nor resists. [SUP-2]
void PatchSystem::slide_blocks() {
  std::vector<double>& values = cholesky_.values();
  using Block = Eigen::Map<Eigen::Matrix3d, 0, Eigen::OuterStride<>>;
  const auto block = [&](const BlockSlot& slot) {
    return Block(values.data() + slot.offset, Eigen::OuterStride<>(slot.stride));
  };
  for (const Slide& slide : patch_->slides) {
    const int v = slide.vertex;
    for (const int w : graph_[v]) {
      const bool is_row = cholesky_.position(v) > cholesky_.position(w);
      auto mixed = block(edge_slots_[is_row ? edge(v, w) : edge(w, v)]);
      const Eigen::Matrix3d whole = mixed;
      mixed = is_row ? Eigen::Matrix3d(slide.track.along * whole)
                     : Eigen::Matrix3d(whole * slide.track.along);
    }
    auto own = block(diagonal_[at(v)]);
    const Eigen::Matrix3d whole = own;
    own = slide.track.along * whole * slide.track.along + Eigen::Matrix3d::Identity() -
          slide.track.along;
  }
}

bool PatchSystem::factorize(const PatchState& state, double smoothing, double penalty,
                            double shift) {
  penalty_ = penalty;
  ++factorizations_;
  row_update_.begin(active_);
  std::copy(constant_.begin(), constant_.end(), cholesky_.values().begin());
  add_norms(state, smoothing, shift);
  add_equations(state, penalty);
  add_inequalities(state);
  slide_blocks();
  return cholesky_.factorize();
}

void PatchSystem::step(const Eigen::Matrix3Xd& gradient, const Eigen::VectorXd& residuals,
                       Eigen::Matrix3Xd& delta, Executor* executor) {
  delta = -gradient;
  jacobian_.add_transposed(-penalty_ * residuals, delta);
  apply_inverse(delta, executor);
}

void PatchSystem::solve(Eigen::Matrix3Xd& x, Executor* executor) {
  lagrangian_.slide(x);
  cholesky_.solve(Eigen::Map<Eigen::VectorXd>(x.data(), x.size()), executor);
  lagrangian_.slide(x);
}

void PatchSystem::apply_inverse(Eigen::Matrix3Xd& x, Executor* executor) {
  solve(x, executor);
  row_update_.apply(limit_jacobian_, x);
}

bool PatchSystem::update() {
  return row_update_.set(active_, limit_penalty_, limit_jacobian_,
                         [&](Eigen::Matrix3Xd& x) { solve(x, nullptr); });
}

void PatchSystem::add_pulls(const Eigen::VectorXd& y, Eigen::Matrix3Xd& out) const {
  jacobian_.add_transposed(y, out);
}

void PatchSystem::apply_jacobian(const Eigen::Matrix3Xd& delta, Eigen::VectorXd& out) const {
  jacobian_.apply(delta, out);
}

}  // namespace planish
