// SPDX-License-Identifier: MIT
#include "planish/engines/patch_system.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "coupling_graph.hpp"
#include "planish/index.hpp"

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

/// Index of block (i, j), i > j, in the order of hessian().
int pair_index(int i, int j) { return i * (i - 1) / 2 + j; }

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
  build_graph();
  cholesky_.analyze(graph_, 3);
  diagonal_.resize(at(patch.free_count));
  for (int v = 0; v < patch.free_count; ++v) diagonal_[at(v)] = cholesky_.slot(v, v);
  place_edges();
  place_equations();
  fill_constant_part();
  gradients_.resize(patch.equations.size());
}

void PatchSystem::build_graph() {
  graph_ = coupling_graph(patch_->free_count, [&](const auto& join) {
    for (const FlatnessEquation& equation : patch_->equations) {
      join_all(equation.vertices, join);
    }
    for (int r = 0; r < patch_->fairness_vertices.size(); ++r) {
      join_all(patch_->fairness_vertices[r], join);
    }
  });
}

/// One slot per edge of the graph: equations and fairness rows then look edges up by row.
void PatchSystem::place_edges() {
  edge_slots_.assign(graph_.values.size(), {});
  for (int v = 0; v < patch_->free_count; ++v) {
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

void PatchSystem::place_equations() {
  const int n = patch_->free_count;
  slots_.resize(patch_->equations.size());
  for (std::size_t e = 0; e < slots_.size(); ++e) {
    const auto& vertices = patch_->equations[e].vertices;
    EquationSlots& place = slots_[e];
    place.order = {0, 1, 2, 3};
    const auto rank = [&](int corner) {
      const int v = vertices[at(corner)];
      return v < n ? cholesky_.position(v) : -1;
    };
    std::sort(place.order.begin(), place.order.end(),
              [&](int a, int b) { return rank(a) > rank(b); });
    place.free = static_cast<int>(
        std::count_if(vertices.begin(), vertices.end(), [&](int v) { return v < n; }));
    std::size_t block = 0;
    for (int late = 0; late < place.free; ++late) {
      const int column = vertices[at(place.order[at(late)])];
      for (int early = 0; early < late; ++early) {
        // order[early] is eliminated later than order[late]: it is the row.
        const int row = vertices[at(place.order[at(early)])];
        place.blocks[block++] = edge_slots_[edge(row, column)];
      }
      place.blocks[block++] = diagonal_[at(column)];
    }
  }
}

void PatchSystem::fill_constant_part() {
  const int n = patch_->free_count;
  std::vector<double> diagonal(at(n));
  for (int v = 0; v < n; ++v) diagonal[at(v)] = patch_->terms[at(v)].square_weight;
  edge_weights_.assign(graph_.values.size(), 0.0);
  for (int r = 0; r < patch_->fairness_vertices.size(); ++r) {
    const auto row = patch_->fairness_vertices[r];
    const double* const entries =
        patch_->fairness_values.data() + patch_->fairness_vertices.offsets[at(r)];
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (row[k] >= n) continue;
      const double weight = patch_->fairness_weight * entries[k];
      diagonal[at(row[k])] += weight * entries[k];
      for (std::size_t l = 0; l < k; ++l) {
        if (row[l] >= n) continue;
        const bool later = cholesky_.position(row[k]) > cholesky_.position(row[l]);
        const std::size_t index = later ? edge(row[k], row[l]) : edge(row[l], row[k]);
        edge_weights_[index] += weight * entries[l];
      }
    }
  }
  cholesky_.set_zero();
  std::vector<double>& values = cholesky_.values();
  for (int v = 0; v < n; ++v) add_diagonal(values, diagonal_[at(v)], diagonal[at(v)]);
  for (std::size_t k = 0; k < edge_weights_.size(); ++k) {
    if (edge_weights_[k] != 0.0) add_diagonal(values, edge_slots_[k], edge_weights_[k]);
  }
  constant_ = values;
}

Eigen::Vector3d PatchSystem::displaced(const Eigen::Matrix3Xd& displacement, int v) const {
  return v < patch_->free_count ? Eigen::Vector3d(displacement.col(v))
                                : Eigen::Vector3d(patch_->displacement.col(v));
}

FourPoints PatchSystem::corners_at(const Eigen::Matrix3Xd& displacement,
                                   const FlatnessEquation& equation) const {
  if (constraints_ == Constraints::kExact) {
    return planish::corners_at(*patch_, displacement, equation);
  }
  FourPoints result;
  for (int k = 0; k < 4; ++k) result.col(k) = patch_->points.col(equation.vertices[at(k)]);
  return result;
}

void PatchSystem::add_equations(const PatchState& state, double penalty) {
  std::vector<double>& values = cholesky_.values();
  for (std::size_t e = 0; e < slots_.size(); ++e) {
    const FlatnessEquation& equation = patch_->equations[e];
    const FourPoints points = corners_at(state.displacement, equation);
    const FourPoints g = gradient(equation, points);
    const auto curvature = hessian(equation, points);
    gradients_[e] = g;
    const double lambda =
        constraints_ == Constraints::kExact ? state.multipliers[static_cast<Eigen::Index>(e)] : 0.0;
    const EquationSlots& place = slots_[e];
    std::size_t block = 0;
    for (int late = 0; late < place.free; ++late) {
      const int column = place.order[at(late)];
      for (int early = 0; early <= late; ++early) {
        const int row = place.order[at(early)];
        Eigen::Matrix3d sum = (penalty * g.col(row)) * g.col(column).transpose();
        if (row > column) {
          sum += lambda * curvature[at(pair_index(row, column))];
        } else if (row < column) {
          sum += lambda * curvature[at(pair_index(column, row))].transpose();
        }
        add_block(values, place.blocks[block++], sum);
      }
    }
  }
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

bool PatchSystem::factorize(const PatchState& state, double smoothing, double penalty,
                            double shift) {
  penalty_ = penalty;
  ++factorizations_;
  std::copy(constant_.begin(), constant_.end(), cholesky_.values().begin());
  add_norms(state, smoothing, shift);
  add_equations(state, penalty);
  return cholesky_.factorize();
}

void PatchSystem::fairness_gradient(const Eigen::Matrix3Xd& displacement,
                                    Eigen::Matrix3Xd& out) const {
  for (int r = 0; r < patch_->fairness_vertices.size(); ++r) {
    const auto row = patch_->fairness_vertices[r];
    const double* const values =
        patch_->fairness_values.data() + patch_->fairness_vertices.offsets[at(r)];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < row.size(); ++k) sum += values[k] * displaced(displacement, row[k]);
    sum *= patch_->fairness_weight;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (row[k] < patch_->free_count) out.col(row[k]) += values[k] * sum;
    }
  }
}

void PatchSystem::lagrangian_gradient(const PatchState& state, double smoothing,
                                      Eigen::Matrix3Xd& out) const {
  out.setZero(3, patch_->free_count);
  fairness_gradient(state.displacement, out);
  for (int v = 0; v < patch_->free_count; ++v) {
    const VertexTerm& term = patch_->terms[at(v)];
    const Eigen::Vector3d d = state.displacement.col(v);
    out.col(v) += term.square_weight * (d - term.target);
    if (term.norm_weight > 0.0) {
      out.col(v) +=
          (0.5 * term.norm_weight / std::sqrt(d.squaredNorm() + smoothing * smoothing)) * d;
    }
  }
  for (std::size_t e = 0; e < patch_->equations.size(); ++e) {
    const FlatnessEquation& equation = patch_->equations[e];
    const double lambda = state.multipliers[static_cast<Eigen::Index>(e)];
    const FourPoints points = corners_at(state.displacement, equation);
    const FourPoints g = gradient(equation, points);
    for (int k = 0; k < 4; ++k) {
      const int v = equation.vertices[at(k)];
      if (v < patch_->free_count) out.col(v) += lambda * g.col(k);
    }
  }
}

void PatchSystem::step(const Eigen::Matrix3Xd& gradient, const Eigen::VectorXd& residuals,
                       Eigen::Matrix3Xd& delta) {
  delta = -gradient;
  for (std::size_t e = 0; e < patch_->equations.size(); ++e) {
    const double push = penalty_ * residuals[static_cast<Eigen::Index>(e)];
    for (int k = 0; k < 4; ++k) {
      const int v = patch_->equations[e].vertices[at(k)];
      if (v < patch_->free_count) delta.col(v) -= push * gradients_[e].col(k);
    }
  }
  apply_inverse(delta);
}

void PatchSystem::apply_inverse(Eigen::Matrix3Xd& x) {
  cholesky_.solve(Eigen::Map<Eigen::VectorXd>(x.data(), x.size()));
}

void PatchSystem::apply_jacobian(const Eigen::Matrix3Xd& delta, Eigen::VectorXd& out) const {
  out.setZero(static_cast<Eigen::Index>(patch_->equations.size()));
  for (std::size_t e = 0; e < patch_->equations.size(); ++e) {
    for (int k = 0; k < 4; ++k) {
      const int v = patch_->equations[e].vertices[at(k)];
      if (v < patch_->free_count) {
        out[static_cast<Eigen::Index>(e)] += gradients_[e].col(k).dot(delta.col(v));
      }
    }
  }
}

double PatchSystem::energy(const Eigen::Matrix3Xd& displacement, double smoothing) const {
  double sum = 0.0;
  for (int v = 0; v < patch_->free_count; ++v) {
    const VertexTerm& term = patch_->terms[at(v)];
    const Eigen::Vector3d d = displacement.col(v);
    sum += 0.5 * term.square_weight * (d - term.target).squaredNorm();
    if (term.norm_weight > 0.0) {
      sum += 0.5 * term.norm_weight * std::sqrt(d.squaredNorm() + smoothing * smoothing);
    }
  }
  for (int r = 0; r < patch_->fairness_vertices.size(); ++r) {
    const auto row = patch_->fairness_vertices[r];
    const double* const values =
        patch_->fairness_values.data() + patch_->fairness_vertices.offsets[at(r)];
    Eigen::Vector3d total = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < row.size(); ++k)
      total += values[k] * displaced(displacement, row[k]);
    sum += 0.5 * patch_->fairness_weight * total.squaredNorm();
  }
  return sum;
}

void PatchSystem::residuals(const Eigen::Matrix3Xd& displacement, Eigen::VectorXd& out) const {
  out.resize(static_cast<Eigen::Index>(patch_->equations.size()));
  for (std::size_t e = 0; e < patch_->equations.size(); ++e) {
    const FlatnessEquation& equation = patch_->equations[e];
    const FourPoints points = corners_at(displacement, equation);
    double& value = out[static_cast<Eigen::Index>(e)];
    if (constraints_ == Constraints::kExact) {
      value = residual(equation, points);
      continue;
    }
    const FourPoints g = gradient(equation, points);
    value = 0.0;
    for (int k = 0; k < 4; ++k) {
      value += g.col(k).dot(displaced(displacement, equation.vertices[at(k)]));
    }
  }
}

}  // namespace planish
