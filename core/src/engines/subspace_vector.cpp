// SPDX-License-Identifier: MIT
#include "engines/subspace_vector.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engines/largest.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

Eigen::Map<const Eigen::VectorXd> flat(const Eigen::Matrix3Xd& t) { return {t.data(), t.size()}; }

/// False where next to nothing is left of a vector that was `before` long.
bool normalise(double before, Eigen::Matrix3Xd& t) {
  constexpr double kNothingLeft = 1e-6;
  const double length = t.norm();
  if (!(length > kNothingLeft * before) || !std::isfinite(length)) return false;
  t /= length;
  return true;
}

/// The patch with only some of its free vertices left free; the others become its halo.
Patch restricted(const Patch& patch, const std::vector<int>& kept, std::vector<int>& order) {
  Patch result;
  std::vector<int> local(at(patch.local_count()), -1);
  order.clear();
  for (const int v : kept) {
    local[at(v)] = static_cast<int>(order.size());
    order.push_back(v);
  }
  result.free_count = static_cast<int>(order.size());
  for (int v = 0; v < patch.local_count(); ++v) {
    if (local[at(v)] >= 0) continue;
    local[at(v)] = static_cast<int>(order.size());
    order.push_back(v);
  }
  result.points.resize(3, patch.local_count());
  result.displacement.setZero(3, patch.local_count());
  for (std::size_t k = 0; k < order.size(); ++k) {
    result.vertices.push_back(patch.vertices[at(order[k])]);
    result.points.col(static_cast<Eigen::Index>(k)) = patch.points.col(order[k]);
  }
  result.terms.resize(at(result.free_count));
  ConstraintKinds::With<SurfacePoint>::for_each([&](auto tag) {
    using Kind = typename decltype(tag)::type;
    for (typename Kind::Row row : patch.equations.of<Kind>()) {
      if (localise(row.vertices, local, result.free_count))
        result.equations.of<Kind>().push_back(row);
    }
  });
  for (Slide slide : patch.slides) {
    slide.vertex = local[at(slide.vertex)];
    if (slide.vertex < result.free_count) result.slides.push_back(slide);
  }
  return result;
}

}  // namespace

SubspaceVectorSolver::SubspaceVectorSolver(Patch& patch, EvenPart even)
    : patch_(patch), even_(std::move(even)) {
  system_.attach(patch, PatchSystem::Constraints::kLinearised);
  dual_ = correction_.attach(patch);
  if (dual_) {
    dual_ = correction_.factorize(Eigen::Matrix3Xd::Zero(3, patch.free_count), 1e-12);
  }
  state_.norm_dual.setZero(3, patch.free_count);
  state_.multipliers.setZero(static_cast<Eigen::Index>(patch.equations.size()));
}

double SubspaceVectorSolver::tangency_error(const Eigen::Matrix3Xd& t) const {
  Eigen::VectorXd out;
  system_.lagrangian().residuals(t, out);
  return largest_entry(out);
}

/// Orthogonal projection onto null(J).
void SubspaceVectorSolver::to_tangent(ConstraintCorrection& correction, Eigen::Matrix3Xd& x) const {
  Eigen::VectorXd image;
  Eigen::Matrix3Xd delta;
  for (int pass = 0; pass < 3; ++pass) {  // each pass leaves the regularisation's share only
    correction.apply_jacobian(x, image);
    correction.step(image, delta);
    x += delta;
  }
}

/// Orthogonal projection onto null(J) ∩ B⊥. B is projected first, so that removing it stays in
/// null(J) even where the patch is smaller than B's support.
bool SubspaceVectorSolver::project(ConstraintCorrection& correction, const Patch& patch,
                                   const Eigen::MatrixXd& basis, Eigen::Matrix3Xd& t) const {
  const double before = t.norm();
  to_tangent(correction, t);
  if (basis.cols() > 0) {
    Eigen::MatrixXd projected(basis.rows(), basis.cols());
    for (Eigen::Index k = 0; k < basis.cols(); ++k) {
      Eigen::Matrix3Xd column =
          Eigen::Map<const Eigen::Matrix3Xd>(basis.col(k).data(), 3, patch.free_count);
      to_tangent(correction, column);
      projected.col(k) = flat(column);
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(projected);
    Eigen::Map<Eigen::VectorXd> vector(t.data(), t.size());
    for (int pass = 0; pass < 2; ++pass) {
      vector -= projected * qr.solve(Eigen::VectorXd(vector));
    }
  }
  return normalise(before, t);
}

bool SubspaceVectorSolver::make_admissible(const Eigen::MatrixXd& basis, Eigen::Matrix3Xd& t) {
  if (even_) even_(t);
  return admit(basis, t);
}

/// Does what project() does where B is orthonormal and tangent.
bool SubspaceVectorSolver::admit(const Eigen::MatrixXd& basis, Eigen::Matrix3Xd& t) {
  const double before = t.norm();
  if (!dual_ || !(before > 0.0)) return false;
  to_tangent(correction_, t);
  Eigen::Map<Eigen::VectorXd> rows(t.data(), t.size());
  for (int pass = 0; pass < 2; ++pass) {
    rows -= basis * (basis.transpose() * Eigen::VectorXd(rows));
  }
  return normalise(before, t);
}

/// Takes one step of state_.displacement = t, which stays admissible. False when it no longer
/// helps.
bool SubspaceVectorSolver::newton_step(const Eigen::MatrixXd& basis, double smoothing,
                                       double penalty) {
  constexpr int kMostHalvings = 8;
  Eigen::Matrix3Xd& t = state_.displacement;
  if (!system_.factorize(state_, smoothing, penalty, 1e-9)) return false;
  ++steps_;
  Eigen::Matrix3Xd gradient;
  Eigen::VectorXd residuals;
  state_.multipliers.setZero();
  system_.lagrangian().gradient_at(state_, smoothing, gradient);
  system_.lagrangian().residuals(t, residuals);
  Eigen::Matrix3Xd delta;
  system_.step(gradient, residuals, delta);
  // Rows G = [tᵀ; Bᵀ]: δ ← δ − K⁻¹Gᵀ (G K⁻¹ Gᵀ)⁻¹ G δ.
  const Eigen::Index rows = basis.cols() + 1;
  Eigen::MatrixXd normals(t.size(), rows);
  normals.col(0) = flat(t);
  normals.rightCols(basis.cols()) = basis;
  Eigen::MatrixXd solved(t.size(), rows);
  for (Eigen::Index k = 0; k < rows; ++k) {
    Eigen::Matrix3Xd column =
        Eigen::Map<const Eigen::Matrix3Xd>(normals.col(k).data(), 3, patch_.free_count);
    system_.apply_inverse(column);
    solved.col(k) = flat(column);
  }
  const Eigen::MatrixXd schur = normals.transpose() * solved;
  Eigen::Map<Eigen::VectorXd> step(delta.data(), delta.size());
  step -= solved * schur.ldlt().solve(normals.transpose() * Eigen::VectorXd(step));
  if (even_) even_(delta);
  const double before = system_.lagrangian().energy(t, smoothing);
  double share = 1.0;
  for (int halving = 0; halving < kMostHalvings; ++halving, share *= 0.5) {
    Eigen::Matrix3Xd trial = t + share * delta;
    trial /= trial.norm();
    if (!(system_.lagrangian().energy(trial, smoothing) < before)) continue;
    t.swap(trial);
    update_norm_duals(trial, smoothing, state_);
    return true;
  }
  return false;
}

double SubspaceVectorSolver::improve(const Eigen::MatrixXd& basis,
                                     const SubspaceVectorOptions& options, Eigen::Matrix3Xd& t) {
  state_.displacement = t;
  state_.norm_dual.setZero();
  double share = options.first_smoothing;
  double last = system_.lagrangian().energy(t, 0.0);
  for (int step = 0; step < options.max_steps; ++step) {
    const double largest = state_.displacement.colwise().norm().maxCoeff();
    const bool moved = newton_step(basis, share * largest, options.penalty);
    const double now = system_.lagrangian().energy(state_.displacement, 0.0);
    const bool settled = !moved || std::abs(last - now) <= options.stop * now;
    last = now;
    if (share <= options.last_smoothing && settled) break;
    share = std::max(options.last_smoothing, options.smoothing_shrink * share);
  }
  t = state_.displacement;
  (void)admit(basis, t);
  return objective(t);
}

void SubspaceVectorSolver::sparsify(const Eigen::MatrixXd& basis, double threshold,
                                    Eigen::Matrix3Xd& t) {
  const double largest = t.colwise().norm().maxCoeff();
  std::vector<int> kept;
  for (int v = 0; v < patch_.free_count; ++v) {
    if (t.col(v).norm() > threshold * largest) kept.push_back(v);
  }
  if (static_cast<int>(kept.size()) == patch_.free_count) return;
  std::vector<int> order;
  const Patch small = restricted(patch_, kept, order);
  ConstraintCorrection correction;
  if (!correction.attach(small)) return;
  if (!correction.factorize(Eigen::Matrix3Xd::Zero(3, small.free_count), 1e-12)) return;
  Eigen::Matrix3Xd rows(3, small.free_count);
  Eigen::MatrixXd basis_rows(3 * small.free_count, basis.cols());
  for (int k = 0; k < small.free_count; ++k) {
    rows.col(k) = t.col(order[at(k)]);
    basis_rows.middleRows<3>(3 * k) = basis.middleRows<3>(3 * order[at(k)]);
  }
  const Eigen::Matrix3Xd before = rows;
  if (!project(correction, small, basis_rows, rows)) return;
  constexpr double kSameVector = 0.99;
  if (before.cwiseProduct(rows).sum() < kSameVector * before.norm()) return;
  t.setZero();
  for (int k = 0; k < small.free_count; ++k) t.col(order[at(k)]) = rows.col(k);
}

}  // namespace planish
