// SPDX-License-Identifier: MIT
#include "engines/subspace_splitting.hpp"

#include <cmath>

#include "planish/numeric/index.hpp"

namespace planish {
SubspaceSplitting::SubspaceSplitting(const Patch& patch, const Eigen::MatrixXd& basis,
                                     const Eigen::Matrix3Xd& start, Executor* executor)
    : patch_(patch),
      basis_(basis),
      executor_(executor),
      quadratic_(patch),
      t_(start),
      y_(start),
      q_(start),
      m_(start) {
  for (VertexTerm& term : quadratic_.terms) term.norm_weight = 0.0;
  y_multiplier_.setZero(3, patch.free_count);
  q_multiplier_ = m_multiplier_ = y_multiplier_;
  const auto equations = static_cast<Eigen::Index>(patch.equations.size());
  tangent_multiplier_.setZero(equations);
  rows_ = static_cast<double>(9 * patch.free_count + equations);
}

/// [μ(3I + JᵀJ) + β_f EᵀE + β_h D]: a PatchSystem with penalty μ and shift 3μ.
bool SubspaceSplitting::set_penalty(double penalty) {
  penalty_ = penalty;
  std::unique_ptr<PatchSystem>& system = systems_[penalty];
  if (!system) {
    system = std::make_unique<PatchSystem>();
    system->attach(quadratic_, PatchSystem::Constraints::kLinearised);
    const PatchState zero{Eigen::Matrix3Xd::Zero(3, patch_.free_count),
                          Eigen::Matrix3Xd::Zero(3, patch_.free_count), tangent_multiplier_};
    if (!system->factorize(zero, 1.0, penalty, 3.0 * penalty)) return false;
  }
  system_ = system.get();
  return true;
}

void SubspaceSplitting::update_auxiliaries() {
  for (int v = 0; v < patch_.free_count; ++v) {
    const Eigen::Vector3d a = t_.col(v) - y_multiplier_.col(v) / penalty_;
    const double threshold = 0.5 * patch_.terms[at(v)].norm_weight / penalty_;
    const double length = a.norm();
    if (length <= threshold) {
      y_.col(v).setZero();
    } else {
      y_.col(v) = (1.0 - threshold / length) * a;
    }
  }
  q_ = t_ - q_multiplier_ / penalty_;
  const double length = q_.norm();
  if (length > 0.0) q_ /= length;
  m_ = t_ - m_multiplier_ / penalty_;
  Eigen::Map<Eigen::VectorXd> rows(m_.data(), m_.size());
  if (basis_.cols() > 0) rows -= basis_ * (basis_.transpose() * Eigen::VectorXd(rows));
}

void SubspaceSplitting::update_primal() {
  const Eigen::Matrix3Xd before = t_;
  // μ(a^y + a^q + a^m) − Jᵀλᵗ with a = x + λ/μ; step() adds −Jᵀ(μ · residual), residual = λᵗ/μ.
  const Eigen::Matrix3Xd pull =
      -(penalty_ * (y_ + q_ + m_) + y_multiplier_ + q_multiplier_ + m_multiplier_);
  const Eigen::VectorXd push = tangent_multiplier_ / penalty_;
  system_->step(pull, push, t_, executor_);
  Eigen::VectorXd image;
  system_->apply_jacobian(t_ - before, image);
  dual_residual_ =
      penalty_ * std::sqrt((3.0 * (t_ - before).squaredNorm() + image.squaredNorm()) / rows_);
}

double SubspaceSplitting::update_multipliers() {
  y_multiplier_ += penalty_ * (y_ - t_);
  q_multiplier_ += penalty_ * (q_ - t_);
  m_multiplier_ += penalty_ * (m_ - t_);
  Eigen::VectorXd image;
  system_->apply_jacobian(t_, image);
  tangent_multiplier_ += penalty_ * image;
  const double square = (y_ - t_).squaredNorm() + (q_ - t_).squaredNorm() +
                        (m_ - t_).squaredNorm() + image.squaredNorm();
  return std::sqrt(square / rows_);
}

double SubspaceSplitting::objective() const {
  double sum = system_->lagrangian().energy(t_, 0.0);
  for (int v = 0; v < patch_.free_count; ++v) {
    sum += 0.5 * patch_.terms[at(v)].norm_weight * t_.col(v).norm();
  }
  return sum;
}

}  // namespace planish
