// SPDX-License-Identifier: MIT
/// One basis vector of (7) by Newton's method on a bounded support. [SUB-4]
///
///   min Q(t) + Σ_i C^i/2 ‖t_i‖   s.t.  J t = 0,  Bᵀ t = 0,  ‖t‖ = 1
///
/// The sphere is taken by its tangent plane tᵀδ = 0 at the last iterate and the result
/// renormalised: the objective grows with the length of t, so both halves of a step lower it.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "engines/constraint_correction.hpp"
#include "engines/patch_system.hpp"
#include "planish/problem/problem.hpp"
#include "planish/problem/solve_report.hpp"

namespace planish {

struct SubspaceVectorOptions {
  double first_smoothing = 0.1;   ///< ε as a share of max‖t_i‖, > last
  double last_smoothing = 1e-5;   ///< ε as a share of max‖t_i‖
  double smoothing_shrink = 0.4;  ///< in (0, 1)
  double penalty = 1e6;           ///< μ of [WSN-2]
  double stop = 1e-5;             ///< relative change of the objective, > 0
  int max_steps = 80;
};

/// Finds vectors one after the other on the same patch; the patch's terms carry C^i and β_h.
class SubspaceVectorSolver {
 public:
  /// The part of 3 × free displacements that a symmetry of the problem keeps.
  using EvenPart = std::function<void(Eigen::Matrix3Xd&)>;

  /// @param patch undisplaced, at p⁺; its norm weights may be changed between calls
  /// @param even every vector is even, and so every step; none: any vector will do [SYM-3]
  explicit SubspaceVectorSolver(Patch& patch, EvenPart even = {});

  /// Projects onto {J t = 0, Bᵀt = 0}, of a start's even part, and normalises. False when nothing
  /// of it is left.
  /// @param basis 3·free × k, orthonormal and tangent
  [[nodiscard]] bool make_admissible(const Eigen::MatrixXd& basis, Eigen::Matrix3Xd& t);

  /// Improves an admissible start in place; returns the objective, without the constant −β_c terms.
  double improve(const Eigen::MatrixXd& basis, const SubspaceVectorOptions& options,
                 Eigen::Matrix3Xd& t);

  /// Goes from a vector that improve() left to a first-order point of its problem, its support
  /// included: ε falls further, Newton's steps have the sphere's curvature, and what is at rest
  /// becomes exactly zero. Returns how well the conditions hold: stationarity on the support and
  /// the bound outside it, with the multipliers of J t = 0, Bᵀt = 0 and ‖t‖ = 1. [SUB-8]
  [[nodiscard]] Optimality settle(const Eigen::MatrixXd& basis, Eigen::Matrix3Xd& t);

  /// Sets rows that the smoothing left to exactly zero and projects on what remains. Leaves t as it
  /// is when the remaining rows do not admit a tangent vector.
  void sparsify(const Eigen::MatrixXd& basis, double threshold, Eigen::Matrix3Xd& t);

  /// Q(t) + Σ C^i/2 ‖t_i‖.
  [[nodiscard]] double objective(const Eigen::Matrix3Xd& t) const {
    return system_.lagrangian().energy(t, 0.0);
  }
  /// max |J t|
  [[nodiscard]] double tangency_error(const Eigen::Matrix3Xd& t) const;

  [[nodiscard]] int steps() const { return steps_; }

 private:
  [[nodiscard]] bool admit(const Eigen::MatrixXd& basis, Eigen::Matrix3Xd& t);
  void to_tangent(ConstraintCorrection& correction, Eigen::Matrix3Xd& x) const;
  [[nodiscard]] Eigen::Matrix3Xd along_constraints(const Eigen::MatrixXd& basis,
                                                   const Eigen::Matrix3Xd& pulls);
  /// What pulls at state_ within the constraints, and the forces that take up the rest.
  struct Pulls {
    Eigen::Matrix3Xd left, forces;  ///< 3 × free
    double sphere = 0.0;            ///< τ of ‖t‖ = 1
  };
  [[nodiscard]] Pulls pulls_at(const Eigen::MatrixXd& basis, double smoothing);
  [[nodiscard]] bool settle_step(const Eigen::MatrixXd& basis, double smoothing,
                                 const Pulls& pulls);
  [[nodiscard]] Eigen::VectorXd curved_step(const Eigen::MatrixXd& normals,
                                            const Eigen::VectorXd& slope, double sphere);
  double settle_at(const Eigen::MatrixXd& basis, double smoothing, bool is_last);
  [[nodiscard]] bool shrink_rests(const Eigen::MatrixXd& basis, double smoothing, double share);
  [[nodiscard]] bool newton_step(const Eigen::MatrixXd& basis, double smoothing, double penalty);
  [[nodiscard]] bool project(ConstraintCorrection& correction, const Patch& patch,
                             const Eigen::MatrixXd& basis, Eigen::Matrix3Xd& t) const;

  Patch& patch_;
  EvenPart even_;
  PatchSystem system_;
  PatchState state_;
  ConstraintCorrection correction_;
  bool dual_ = true;
  int steps_ = 0;
};

}  // namespace planish
