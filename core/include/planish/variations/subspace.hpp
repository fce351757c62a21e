// SPDX-License-Identifier: MIT
/// Problem (7): a small orthonormal family of local variations around an edit.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "planish/edit/kept_by_variations.hpp"
#include "planish/measures/energies.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/numeric/executor.hpp"
#include "planish/problem/engine.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

struct SubspaceOptions {
  int dimension = 4;              ///< s in 1 … 24
  double fairness_weight = 3.0;   ///< β_f ≥ 0; higher: smoother, wider vectors [SUB-1]
  double sparsity_weight = 1.0;   ///< β_s > 0; higher: fewer vertices per vector [SUB-2]
  double closeness_weight = 0.0;  ///< β_h ≥ 0 on the handles Ψ; higher: they stay put [SUB-1]
  double correlation = 0.95;      ///< β_c as a share of its bound, in [0, 1) [SUB-3]
  int reach = 2;                  ///< face rings around the edit that vectors may use, ≥ 0
  bool eigenbasis = false;        ///< reorder by the reduced Hessian of Q, smallest first [SUB-5]
  /// With the eigenbasis: how many vectors it is made of; the first `dimension` of it are kept. 0:
  /// `dimension`. Otherwise from `dimension` to 24.
  int family = 0;
  FairnessKind fairness = FairnessKind::kSecondDifference;
  Engine engine = Engine::kNewton;
};

[[nodiscard]] Refusal find_problem(const SubspaceOptions& options);

/// ξ(u, v) = Σ_i ‖u_i‖ ‖v_i‖: by how much two displacements move the same vertices, in [0, 1] for
/// unit ones; 0 exactly where they move none in common. (5) [SUB-3]
[[nodiscard]] double correlation(const Eigen::Matrix3Xd& u, const Eigen::Matrix3Xd& v);

/// How good the basis is; every figure is measured on the result.
struct SubspaceReport {
  /// kConverged: as many vectors as asked for, each a first-order point of its problem; by the
  /// paper's engine, each as its own residuals say.
  SolveStatus status = SolveStatus::kIterationLimit;
  /// Of each vector of (7), before the eigenbasis mixes them; none by the paper's engine. [SUB-8]
  std::vector<Optimality> certificates;
  double orthonormality_error = 0.0;  ///< max |BᵀB − I|
  double tangency_error = 0.0;        ///< max |J t|, mean-edge units per unit vector
  std::vector<double> correlation;    ///< ξ(d̄, t^k) of each vector [SUB-3]
  std::vector<double> fairness;       ///< ‖E t^k‖² of each vector, beside the edit's own
  double edit_fairness = 0.0;         ///< ‖E d̄‖²
  std::vector<int> support_sizes;     ///< vertices moved by each vector
  int iterations = 0;
  double solve_seconds = 0.0;
};

/// B, stored on its support rows only. The design for coefficients x is p⁺ + scale · B x.
struct Subspace {
  std::vector<int> support;  ///< ascending vertex indices, length r
  Positions origin;          ///< 3 × r, p⁺ on the support, model units
  Eigen::MatrixXd basis;     ///< 3r × s, orthonormal; row 3k + c is coordinate c of support[k]
  /// Model units per coefficient 1: |x| = 1 moves some vertex by the edit's own largest move.
  Eigen::VectorXd scale;  ///< s
  SubspaceReport report;

  [[nodiscard]] int dimension() const { return static_cast<int>(basis.cols()); }
};

/// Computes the basis at `edited` = p⁰ + d, for the displacement d from `base`.
/// Both meshes share faces; `edited` keeps the kinds of `keeps`. `close` is Ψ, usually the handles.
/// @param executor as in HandleEditOptions
[[nodiscard]] Subspace compute_subspace(const Mesh& base, const Positions& edited,
                                        const std::vector<int>& close,
                                        const SubspaceOptions& options,
                                        const KeptByVariations& keeps = {},
                                        const Progress& progress = {},
                                        Executor* executor = nullptr);

/// Ψ where nothing else is asked for: the vertices of the handles.
[[nodiscard]] std::vector<int> handle_vertices(const EditTargets& targets);

/// Positions of the support rows for coefficients x: origin + B (scale ∘ x). Touches nothing else.
/// @param coefficients s values
/// @param out 3 × r, overwritten; never allocates when already that size
void evaluate(const Subspace& subspace, const Eigen::Ref<const Eigen::VectorXd>& coefficients,
              Positions& out);

}  // namespace planish
