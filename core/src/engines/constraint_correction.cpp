// SPDX-License-Identifier: MIT
#include "engines/constraint_correction.hpp"

#include <algorithm>
#include <cmath>

#include "engines/patch_system.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

RaggedRows equations_of_vertices(const RowJacobian& jacobian, int free_count) {
  RaggedRows rows;
  rows.offsets.assign(at(free_count) + 1, 0);
  const auto for_each_entry = [&](const auto& visit) {
    for (int e = 0; e < jacobian.size(); ++e) {
      for (const int v : jacobian.vertices(e)) {
        if (v < free_count) visit(e, v);
      }
    }
  };
  for_each_entry([&](int, int v) { ++rows.offsets[at(v) + 1]; });
  for (std::size_t v = 1; v < rows.offsets.size(); ++v) rows.offsets[v] += rows.offsets[v - 1];
  rows.values.resize(at(rows.offsets.back()));
  std::vector<int> next(rows.offsets.begin(), rows.offsets.end() - 1);
  for_each_entry([&](int e, int v) { rows.values[at(next[at(v)]++)] = e; });
  return rows;
}

/// Equations that share a free vertex.
RaggedRows coupled_equations(const RowJacobian& jacobian, const RaggedRows& by_vertex) {
  RaggedRows graph;
  std::vector<int> mark(at(jacobian.size()), -1);
  for (int e = 0; e < jacobian.size(); ++e) {
    mark[at(e)] = e;
    for (const int v : jacobian.vertices(e)) {
      if (v >= by_vertex.size()) continue;
      for (const int other : by_vertex[v]) {
        if (mark[at(other)] == e) continue;
        mark[at(other)] = e;
        graph.values.push_back(other);
      }
    }
    graph.offsets.push_back(static_cast<int>(graph.values.size()));
  }
  return graph;
}

}  // namespace

bool ConstraintCorrection::attach(const Patch& patch) {
  constexpr int kMostEquationsPerVertex = 64;
  patch_ = &patch;
  jacobian_.attach(patch);
  const RaggedRows by_vertex = equations_of_vertices(jacobian_, patch.free_count);
  for (int v = 0; v < patch.free_count; ++v) {
    if (by_vertex[v].size() > at(kMostEquationsPerVertex)) return false;
  }
  const RaggedRows graph = coupled_equations(jacobian_, by_vertex);
  cholesky_.analyze(graph, 1);
  diagonal_.clear();
  couplings_.clear();
  for (int e = 0; e < graph.size(); ++e) {
    diagonal_.push_back(cholesky_.slot(e, e));
    for (const int other : graph[e]) {
      if (cholesky_.position(e) > cholesky_.position(other)) {
        couplings_.push_back({e, other, cholesky_.slot(e, other)});
      }
    }
  }
  return true;
}

bool ConstraintCorrection::factorize(const Eigen::Matrix3Xd& displacement, double regularization) {
  ++factorizations_;
  jacobian_.evaluate(*patch_, displacement);
  cholesky_.set_zero();
  std::vector<double>& values = cholesky_.values();
  for (int e = 0; e < jacobian_.size(); ++e) {
    values[static_cast<std::size_t>(diagonal_[at(e)].offset)] =
        jacobian_.product(e, e, regularization);
  }
  for (const Coupling& coupling : couplings_) {
    values[static_cast<std::size_t>(coupling.slot.offset)] =
        jacobian_.product(coupling.row, coupling.column);
  }
  return cholesky_.factorize();
}

void ConstraintCorrection::step(const Eigen::VectorXd& residuals, Eigen::Matrix3Xd& delta) {
  multipliers_ = -residuals;
  cholesky_.solve(multipliers_);
  delta.setZero(3, patch_->free_count);
  jacobian_.add_transposed(multipliers_, delta);
}

void ConstraintCorrection::project(Eigen::Matrix3Xd& x) {
  jacobian_.apply(x, multipliers_);
  multipliers_ = -multipliers_;
  cholesky_.solve(multipliers_);
  jacobian_.add_transposed(multipliers_, x);
}

void ConstraintCorrection::apply_jacobian(const Eigen::Matrix3Xd& delta,
                                          Eigen::VectorXd& out) const {
  jacobian_.apply(delta, out);
}

namespace {

/// One linearisation, whichever way suits the patch.
class Corrector {
 public:
  explicit Corrector(const Patch& patch) : dual_(correction_.attach(patch)) {
    if (dual_) return;
    // J Jᵀ would be dense: (I + μ JᵀJ) has the same limit and stays sparse.
    unit_ = patch;
    for (VertexTerm& term : unit_.terms) term = {.square_weight = 1.0};
    unit_.fairness_weight = 0.0;
    system_.attach(unit_);
    state_.multipliers.setZero(static_cast<Eigen::Index>(patch.equations.size()));
    state_.norm_dual.setZero(3, patch.free_count);
    zero_.setZero(3, patch.free_count);
  }

  [[nodiscard]] bool linearise(const Eigen::Matrix3Xd& displacement, double regularization) {
    if (dual_) return correction_.factorize(displacement, regularization);
    constexpr double kPenalty = 1e8;
    state_.displacement = displacement;
    return system_.factorize(state_, 1.0, std::min(kPenalty, 1.0 / regularization), 0.0);
  }

  void step(const Eigen::VectorXd& residuals, Eigen::Matrix3Xd& delta) {
    if (dual_) {
      correction_.step(residuals, delta);
    } else {
      system_.step(zero_, residuals, delta);
    }
  }

 private:
  ConstraintCorrection correction_;
  bool dual_ = true;
  Patch unit_;
  PatchSystem system_;
  PatchState state_;
  Eigen::Matrix3Xd zero_;
};

}  // namespace

double correct_constraints(const Patch& patch, int max_passes, Eigen::Matrix3Xd& displacement,
                           int& factorizations) {
  constexpr double kRegularization = 1e-10;
  constexpr double kRounding = 1e-13;
  constexpr double kSmall = 1e-9;
  constexpr double kWorthIt = 0.5;
  constexpr int kMostHalvings = 6;
  if (patch.equations.empty()) return 0.0;
  Eigen::VectorXd residuals;
  Eigen::VectorXd trial_residuals;
  Eigen::Matrix3Xd delta;
  Eigen::Matrix3Xd trial;
  residuals_at(patch, displacement, residuals);
  double worst = residuals.cwiseAbs().maxCoeff();
  if (worst <= kRounding) return worst;
  Corrector corrector(patch);
  double regularization = kRegularization;
  for (int pass = 0; pass < max_passes && worst > kRounding; ++pass) {
    ++factorizations;
    if (!corrector.linearise(displacement, regularization)) {
      regularization *= 100.0;
      continue;
    }
    corrector.step(residuals, delta);
    bool better = false;
    double share = 1.0;
    for (int halving = 0; halving < kMostHalvings && !better; ++halving, share *= 0.5) {
      trial = displacement + share * delta;
      residuals_at(patch, trial, trial_residuals);
      better = trial_residuals.allFinite() && trial_residuals.norm() < residuals.norm();
    }
    if (!better) break;
    // Rows among points that stay keep what the base has of them, and the way to that is no better.
    if (residuals.norm() <= kSmall && trial_residuals.norm() > kWorthIt * residuals.norm()) break;
    displacement = trial;
    residuals = trial_residuals;
    worst = residuals.cwiseAbs().maxCoeff();
  }
  return worst;
}

}  // namespace planish
