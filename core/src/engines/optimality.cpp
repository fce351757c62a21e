// SPDX-License-Identifier: MIT
#include "engines/optimality.hpp"

#include <algorithm>
#include <limits>

#include "engines/constraint_correction.hpp"
#include "engines/patch_lagrangian.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// What is left of a pull on a vertex with supports.
Eigen::Vector3d along_its_track(const Patch& patch, int vertex, const Eigen::Vector3d& pull) {
  const auto found = std::lower_bound(patch.slides.begin(), patch.slides.end(), vertex,
                                      [](const Slide& slide, int v) { return slide.vertex < v; });
  if (found == patch.slides.end() || found->vertex != vertex) return pull;
  return found->track.along * pull;
}

/// ∇F of a problem without norm terms.
Eigen::Matrix3Xd slope_of(const Patch& patch, const Eigen::Matrix3Xd& displacement) {
  Eigen::Matrix3Xd slope(3, patch.free_count);
  if (patch.fairness_weight > 0.0 || patch.shape_weight > 0.0) {
    PatchLagrangian lagrangian;
    lagrangian.attach(patch);
    const PatchState state{
        displacement, Eigen::Matrix3Xd::Zero(3, patch.free_count),
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(patch.equations.size()))};
    lagrangian.gradient_at(state, std::numeric_limits<double>::infinity(), slope);
    return slope;
  }
  for (int k = 0; k < patch.free_count; ++k) {
    slope.col(k) = patch.terms[at(k)].square_weight * displacement.col(k);
  }
  return slope;
}

}  // namespace

Optimality optimality_of(const Patch& patch, const Eigen::Matrix3Xd& displacement,
                         const Eigen::Matrix3Xd& pulls, double rest) {
  constexpr double kUnitPull = 0.5;  // where no vertex has a norm weight: that of weight 1
  double unit = 0.0;
  for (const VertexTerm& term : patch.terms) unit = std::max(unit, 0.5 * term.norm_weight);
  if (unit == 0.0) unit = kUnitPull;
  Optimality result;
  result.certified_vertices = patch.free_count;
  for (int k = 0; k < patch.free_count; ++k) {
    const double bound = 0.5 * patch.terms[at(k)].norm_weight;
    const Eigen::Vector3d d = displacement.col(k);
    if (bound > 0.0 && d.norm() <= rest) {
      result.outside = std::max(result.outside, pulls.col(k).norm() / bound - 1.0);
      continue;
    }
    const Eigen::Vector3d left = along_its_track(patch, k, pulls.col(k) + bound * d.normalized());
    result.stationarity = std::max(result.stationarity, left.norm() / unit);
  }
  return result;
}

std::optional<Optimality> fitted_optimality(const Patch& patch,
                                            const Eigen::Matrix3Xd& displacement) {
  constexpr double kRegularization = 1e-12;
  Eigen::Matrix3Xd pulls = slope_of(patch, displacement);
  if (!patch.equations.empty()) {
    ConstraintCorrection linear;
    if (!linear.attach(patch) || !linear.factorize(displacement, kRegularization)) {
      return std::nullopt;
    }
    Eigen::VectorXd along;
    Eigen::Matrix3Xd share;
    for (int pass = 0; pass < 2; ++pass) {  // the second removes the regularisation's share
      linear.apply_jacobian(pulls, along);
      linear.step(along, share);  // −Jᵀ(JJᵀ)⁻¹ J ∇F = Jᵀλ
      pulls += share;
    }
  }
  return optimality_of(patch, displacement, pulls, 0.0);
}

}  // namespace planish
