// SPDX-License-Identifier: MIT
/// The last part of a vector of (7): from a minimum with a coarse norm to a first-order point of
/// the problem itself. [SUB-8]
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engines/largest.hpp"
#include "engines/optimality.hpp"
#include "engines/subspace_vector.hpp"

namespace planish {
namespace {

/// Figures of the iteration; ε in units of the longest row.
struct VectorSettling {
  static constexpr double kFirst = 1e-5;         ///< ε at which improve() ended
  static constexpr double kLast = 1e-11;         ///< last ε
  static constexpr double kShrink = 0.01;        ///< of ε from stage to stage
  static constexpr double kCarefulShrink = 0.1;  ///< of ε where that did not settle
  static constexpr double kAtRest = 100.0;       ///< times ε: what is shorter is at rest
  static constexpr double kPenalty = 1e6;        ///< μ ε: far stiffer than norms at rest
  static constexpr double kMostPenalty = 1e16;   ///< μ
  static constexpr double kSettled = 1e-3;       ///< pull that is left, of the largest C^i/2
  static constexpr double kStill = 1e-12;        ///< a step at the last ε that is rounding
  static constexpr double kCounted = 1e-6;       ///< of the longest row: less counts as at rest
  static constexpr int kSteps = 30;              ///< at one ε
  static constexpr int kInner = 25;              ///< conjugate gradients in one step
  static constexpr double kInnerDrop = 1e-6;     ///< of their residual's square
};

Eigen::Map<const Eigen::VectorXd> as_vector(const Eigen::Matrix3Xd& t) {
  return {t.data(), t.size()};
}

}  // namespace

/// What is left of `pulls` within null(J) ∩ B⊥ ∩ t⊥: the pulls plus the forces of the multipliers
/// that fit best.
Eigen::Matrix3Xd SubspaceVectorSolver::along_constraints(const Eigen::MatrixXd& basis,
                                                         const Eigen::Matrix3Xd& pulls) {
  Eigen::Matrix3Xd left = pulls;
  to_tangent(correction_, left);
  Eigen::Map<Eigen::VectorXd> rows(left.data(), left.size());
  for (int pass = 0; pass < 2; ++pass) {
    if (basis.cols() > 0) rows -= basis * (basis.transpose() * Eigen::VectorXd(rows));
    rows -= as_vector(state_.displacement) * as_vector(state_.displacement).dot(rows);
  }
  return left;
}

/// min ½ δᵀ(H − τI)δ + gᵀδ on G δ = 0, J δ = 0 by conjugate gradients with (H + μJᵀJ)⁻¹: the
/// factor knows everything but the sphere's curvature τ. What H does to a direction is known from
/// how it was solved for.
/// @param normals t and B, one a column
/// @param slope g
Eigen::VectorXd SubspaceVectorSolver::curved_step(const Eigen::MatrixXd& normals,
                                                  const Eigen::VectorXd& slope, double sphere) {
  const auto solve = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    Eigen::Matrix3Xd column = Eigen::Map<const Eigen::Matrix3Xd>(x.data(), 3, patch_.free_count);
    system_.apply_inverse(column);
    return as_vector(column);
  };
  Eigen::MatrixXd solved(normals.rows(), normals.cols());
  for (Eigen::Index k = 0; k < normals.cols(); ++k) solved.col(k) = solve(normals.col(k));
  const Eigen::LDLT<Eigen::MatrixXd> schur((normals.transpose() * solved).eval());
  Eigen::VectorXd residual = -slope;
  Eigen::VectorXd step = Eigen::VectorXd::Zero(slope.size());
  Eigen::VectorXd direction, bent;  // p and H p, up to forces along the constraints
  double first = 0.0;
  double before = 0.0;
  for (int k = 0; k < VectorSettling::kInner; ++k) {
    Eigen::VectorXd shift = solve(residual);
    const Eigen::VectorXd forces = schur.solve(normals.transpose() * shift);
    shift -= solved * forces;
    const double now = residual.dot(shift);
    if (k == 0) first = now;
    if (!(now > VectorSettling::kInnerDrop * first)) break;
    const Eigen::VectorXd image = residual - normals * forces;
    if (k == 0) {
      direction = shift;
      bent = image;
    } else {
      direction = shift + (now / before) * direction;
      bent = image + (now / before) * bent;
    }
    before = now;
    const Eigen::VectorXd curved = bent - sphere * direction;
    const double curvature = direction.dot(curved);
    if (!(curvature > 0.0)) return k == 0 ? direction : step;
    step += (now / curvature) * direction;
    residual -= (now / curvature) * curved;
  }
  return step;
}

SubspaceVectorSolver::Pulls SubspaceVectorSolver::pulls_at(const Eigen::MatrixXd& basis,
                                                           double smoothing) {
  state_.multipliers.setZero();
  Eigen::Matrix3Xd gradient;
  system_.lagrangian().gradient_at(state_, smoothing, gradient);
  Pulls pulls;
  pulls.sphere = as_vector(state_.displacement).dot(as_vector(gradient));
  pulls.left = along_constraints(basis, gradient);
  pulls.forces = pulls.left - gradient;
  return pulls;
}

/// False when no step helps any more.
bool SubspaceVectorSolver::settle_step(const Eigen::MatrixXd& basis, double smoothing,
                                       const Pulls& pulls) {
  constexpr int kMostHalvings = 8;
  constexpr double kRounding = 1e-13;
  Eigen::Matrix3Xd& t = state_.displacement;
  const double penalty =
      std::clamp(VectorSettling::kPenalty / smoothing, 1e6, VectorSettling::kMostPenalty);
  if (!system_.factorize(state_, smoothing, penalty, 1e-9)) return false;
  ++steps_;
  Eigen::MatrixXd normals(t.size(), basis.cols() + 1);
  normals.col(0) = as_vector(t);
  normals.rightCols(basis.cols()) = basis;
  const Eigen::VectorXd way = curved_step(normals, as_vector(pulls.left), pulls.sphere);
  Eigen::Matrix3Xd step = Eigen::Map<const Eigen::Matrix3Xd>(way.data(), 3, patch_.free_count);
  if (even_) even_(step);
  const double before = system_.lagrangian().energy(t, smoothing);
  double share = 1.0;
  for (int halving = 0; halving < kMostHalvings; ++halving, share *= 0.5) {
    Eigen::Matrix3Xd trial = t + share * step;
    if (!admit(basis, trial)) return false;
    if (!(system_.lagrangian().energy(trial, smoothing) <= before + kRounding * std::abs(before)))
      continue;
    t.swap(trial);
    update_norm_duals(trial, smoothing, state_);
    return true;
  }
  return false;
}

/// Settles at one ε: till the pulls that are left are small, at the last one till steps are
/// rounding.
/// @returns the longest of them, of the largest C^i/2
double SubspaceVectorSolver::settle_at(const Eigen::MatrixXd& basis, double smoothing,
                                       bool is_last) {
  const double bound = largest_pull(patch_);
  Pulls pulls = pulls_at(basis, smoothing);
  double left = longest_column(pulls.left) / bound;
  for (int step = 0; step < VectorSettling::kSteps; ++step) {
    if (!is_last && left <= VectorSettling::kSettled) break;
    const Eigen::Matrix3Xd before = state_.displacement;
    if (!settle_step(basis, smoothing, pulls)) break;
    pulls = pulls_at(basis, smoothing);
    left = longest_column(pulls.left) / bound;
    if ((state_.displacement - before).norm() <= VectorSettling::kStill) break;
  }
  return left;
}

/// Goes from the minimum at one ε to a start at the next: what is at rest shrinks with ε, so that
/// t/√(‖t‖² + ε²) stays what it is. False where nothing admissible is left.
bool SubspaceVectorSolver::shrink_rests(const Eigen::MatrixXd& basis, double smoothing,
                                        double share) {
  Eigen::Matrix3Xd trial = state_.displacement;
  for (int v = 0; v < patch_.free_count; ++v) {
    if (trial.col(v).norm() <= VectorSettling::kAtRest * smoothing) trial.col(v) *= share;
  }
  if (!admit(basis, trial)) return false;
  state_.displacement = trial;
  return true;
}

Optimality SubspaceVectorSolver::settle(const Eigen::MatrixXd& basis, Eigen::Matrix3Xd& t) {
  constexpr double kNoNorms = std::numeric_limits<double>::infinity();
  state_.displacement = t;
  const double largest = longest_column(t);
  const double last = VectorSettling::kLast * largest;
  double smoothing = VectorSettling::kFirst * largest;
  // What the last ε left that was settled; where the next one is not, a nearer one is tried.
  PatchState settled = state_;
  double settled_at = smoothing;
  bool is_found = false;
  double shrink = VectorSettling::kShrink;
  for (;;) {
    const bool is_last = smoothing <= last;
    const bool is_settled = settle_at(basis, smoothing, is_last) <= VectorSettling::kSettled;
    if (is_settled || !is_found) {
      settled = state_;
      settled_at = smoothing;
      is_found = is_settled;
      shrink = is_settled ? VectorSettling::kShrink : VectorSettling::kCarefulShrink;
    } else if (shrink == VectorSettling::kShrink) {
      state_ = settled;
      smoothing = settled_at;
      shrink = VectorSettling::kCarefulShrink;
    } else {
      break;
    }
    const double next = std::max(shrink * smoothing, last);
    if (smoothing <= last || !shrink_rests(basis, smoothing, next / smoothing)) break;
    smoothing = next;
  }
  state_ = settled;
  const Eigen::Matrix3Xd forces = pulls_at(basis, settled_at).forces;
  t = settled.displacement;
  sparsify(basis, VectorSettling::kAtRest * settled_at / longest_column(t), t);
  state_.displacement = t;
  Eigen::Matrix3Xd pulls;
  system_.lagrangian().gradient_at(state_, kNoNorms, pulls);
  return optimality_of(patch_, t, pulls + forces, VectorSettling::kCounted * longest_column(t));
}

}  // namespace planish
