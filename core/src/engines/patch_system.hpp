// SPDX-License-Identifier: MIT
/// One Newton system on a patch: assembly, factorization, step. [WSN-2]
///
///   (H + μ Jᵀ J + ν I) δ = −(∇F + Jᵀ(λ + μ c)),   λ⁺ = λ + μ (c + J δ)
///
/// which is the KKT system [H + νI, Jᵀ; J, −I/μ] with its second row eliminated: positive definite
/// exactly when the KKT matrix has the inertia of a minimum, so a failed factorization is the test.
/// Inequalities with multipliers that are active are rows like the equations, with a penalty of
/// their own.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engines/patch_lagrangian.hpp"
#include "engines/row_jacobian.hpp"
#include "engines/row_update.hpp"
#include "engines/sparse_cholesky.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// Chan–Golub–Mulet's update of w after a step from `before` to state.displacement. [WSN-3]
/// @param smoothing ε > 0
void update_norm_duals(const Eigen::Matrix3Xd& before, double smoothing, PatchState& state);

class PatchSystem {
 public:
  using Constraints = PatchLagrangian::Constraints;

  /// Builds the sparsity pattern; O(patch). Keeps a reference to `patch`.
  void attach(const Patch& patch, Constraints constraints = Constraints::kExact);

  /// Assembles at `state`. @param smoothing ε > 0 of √(‖d‖² + ε²); @param shift ν ≥ 0
  /// @returns false when not positive definite
  [[nodiscard]] bool factorize(const PatchState& state, double smoothing, double penalty,
                               double shift);

  /// Which inequalities are rows of the next factorizations, or of the last one from update() on,
  /// and their penalty > 0. Expects evaluate_limits() at the state of these. [LIM-2]
  void activate(const std::vector<char>& active, double penalty) {
    active_ = active;
    limit_penalty_ = penalty;
  }
  /// The last factorization with the rows that are active now, by solves. @returns false, and it
  /// stands as it was, where too many rows differ or it would not be positive definite
  [[nodiscard]] bool update();
  /// Whether there are inequalities with multipliers.
  [[nodiscard]] bool has_limits() const { return has_limits_; }
  /// The gradients of their shares.
  void evaluate_limits(const Eigen::Matrix3Xd& displacement);
  [[nodiscard]] const RowJacobian& limit_jacobian() const { return limit_jacobian_; }

  /// Without the factor.
  [[nodiscard]] const PatchLagrangian& lagrangian() const { return lagrangian_; }

  /// δ from the last factorization. @param gradient ∇F_ε + Jᵀλ; @param residuals c
  /// @param executor see SparseCholesky::solve()
  void step(const Eigen::Matrix3Xd& gradient, const Eigen::VectorXd& residuals,
            Eigen::Matrix3Xd& delta, Executor* executor = nullptr);

  /// x ← (H + μJᵀJ + νI)⁻¹ x with the last factorization. @param x 3 × free
  void apply_inverse(Eigen::Matrix3Xd& x, Executor* executor = nullptr);

  /// J δ with J of the last factorization.
  void apply_jacobian(const Eigen::Matrix3Xd& delta, Eigen::VectorXd& out) const;

  /// out += Jᵀ y with J of the last factorization. @param out 3 × free
  void add_pulls(const Eigen::VectorXd& y, Eigen::Matrix3Xd& out) const;

  [[nodiscard]] int factorizations() const { return factorizations_; }

 private:
  /// Where the blocks of rows go.
  struct RowPlaces {
    std::vector<int> free;         ///< free vertices of each row
    std::vector<int> order;        ///< row by row: their places in it, latest eliminated first
    std::vector<BlockSlot> slots;  ///< row by row, in that order: (0,0) (0,1) (1,1) (0,2) …
  };

  [[nodiscard]] static RaggedRows graph_of(const Patch& patch);
  void analyze(RaggedRows graph);
  void place_edges();
  [[nodiscard]] std::size_t edge(int row, int column) const;
  template <class Batches>
  void place_rows(const Batches& rows, RowPlaces& places) const;
  void place_row(std::span<const int> vertices, RowPlaces& places) const;
  void fill_constant_part();
  void add_equations(const PatchState& state, double penalty);
  void add_inequalities(const PatchState& state);
  void slide_blocks();
  /// x ← the factor's inverse of it, along what vertices with supports may do.
  void solve(Eigen::Matrix3Xd& x, Executor* executor);
  void add_norms(const PatchState& state, double smoothing, double shift);

  const Patch* patch_ = nullptr;
  PatchLagrangian lagrangian_;
  Constraints constraints_ = Constraints::kExact;
  RaggedRows graph_;
  SparseCholesky cholesky_;
  std::vector<BlockSlot> diagonal_;
  std::vector<BlockSlot> edge_slots_;  ///< layout of graph_.values; set where the row is the later
  std::vector<double> edge_weights_;   ///< ω_f EᵀE, same layout
  RowPlaces equation_places_;
  RowPlaces inequality_places_;
  std::vector<double> constant_;  ///< panel values of ω_f EᵀE + q I
  RowJacobian jacobian_;          ///< of the last factorization
  RowJacobian limit_jacobian_;    ///< of the shares, at the last evaluate_limits(), if has_limits_
  bool has_limits_ = false;
  std::vector<char> active_;  ///< by inequality; empty: none
  RowUpdate row_update_;      ///< from what was active in the factorization
  double limit_penalty_ = 0.0;
  double penalty_ = 0.0;
  int factorizations_ = 0;
};

}  // namespace planish
