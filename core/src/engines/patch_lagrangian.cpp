// SPDX-License-Identifier: MIT
#include "engines/patch_lagrangian.hpp"

#include <cmath>

#include "engines/weighted_barrier.hpp"

namespace planish {

Eigen::Vector3d PatchLagrangian::displaced(const Eigen::Matrix3Xd& displacement, int v) const {
  return v < patch_->free_count ? Eigen::Vector3d(displacement.col(v))
                                : Eigen::Vector3d(patch_->displacement.col(v));
}

void PatchLagrangian::fairness_gradient(const Eigen::Matrix3Xd& displacement,
                                        Eigen::Matrix3Xd& out) const {
  patch_->for_each_fairness_row([&](const FairnessRow& row) {
    Eigen::Vector3d sum = row.sum([&](int v) { return displaced(displacement, v); });
    sum *= patch_->fairness_weight;
    for (std::size_t k = 0; k < row.vertices.size(); ++k) {
      const int v = row.vertices[k];
      if (v < patch_->free_count) out.col(v) += row.weights[k] * sum;
    }
  });
}

void PatchLagrangian::gradient_at(const PatchState& state, double smoothing,
                                  Eigen::Matrix3Xd& out) const {
  out.setZero(3, patch_->free_count);
  fairness_gradient(state.displacement, out);
  inequality_gradient(state, out);
  for (int v = 0; v < patch_->free_count; ++v) {
    const VertexTerm& term = patch_->terms[at(v)];
    const Eigen::Vector3d d = state.displacement.col(v);
    out.col(v) += term.square_weight * (d - term.target);
    if (term.norm_weight > 0.0) {
      out.col(v) +=
          (0.5 * term.norm_weight / std::sqrt(d.squaredNorm() + smoothing * smoothing)) * d;
    }
  }
  patch_->equations.for_each([&]<class Row>(int e, const Row& row) {
    const RowPoints<Row::kArity> g = gradient(row, points_of(row, state.displacement));
    for (int k = 0; k < Row::kArity; ++k) {
      const int v = row.vertices[at(k)];
      if (v < patch_->free_count) out.col(v) += state.multipliers[e] * g.col(k);
    }
  });
  slide(out);
}

void PatchLagrangian::inequality_gradient(const PatchState& state, Eigen::Matrix3Xd& out) const {
  const bool presses = state.limit_multipliers.size() > 0;
  patch_->inequalities.for_each([&](int number, const auto& row) {
    const double pressure = presses ? state.limit_multipliers[number] : 0.0;
    if (has_multiplier(row) && pressure == 0.0) return;
    const auto points = corners_at(*patch_, state.displacement, row);
    const double slope = has_multiplier(row)
                             ? -pressure * row.scale.slope
                             : weighted_barrier(*patch_, row, value(row, points)).slope;
    if (slope == 0.0) return;
    const auto g = gradient(row, points);
    for (std::size_t k = 0; k < row.vertices.size(); ++k) {
      const int v = row.vertices[k];
      if (v < patch_->free_count) out.col(v) += slope * g.col(static_cast<Eigen::Index>(k));
    }
  });
}

void PatchLagrangian::slide(Eigen::Matrix3Xd& x) const {
  for (const Slide& slide : patch_->slides) {
    const Eigen::Vector3d whole = x.col(slide.vertex);
    x.col(slide.vertex) = slide.track.along * whole;
  }
}

double PatchLagrangian::energy(const Eigen::Matrix3Xd& displacement, double smoothing) const {
  double sum = 0.0;
  for (int v = 0; v < patch_->free_count; ++v) {
    const VertexTerm& term = patch_->terms[at(v)];
    const Eigen::Vector3d d = displacement.col(v);
    sum += 0.5 * term.square_weight * (d - term.target).squaredNorm();
    if (term.norm_weight > 0.0) {
      sum += 0.5 * term.norm_weight * std::sqrt(d.squaredNorm() + smoothing * smoothing);
    }
  }
  patch_->for_each_fairness_row([&](const FairnessRow& row) {
    const Eigen::Vector3d total = row.sum([&](int v) { return displaced(displacement, v); });
    sum += 0.5 * patch_->fairness_weight * total.squaredNorm();
  });
  patch_->inequalities.for_each([&](int, const auto& row) {
    if (has_multiplier(row)) return;
    const double g = value(row, corners_at(*patch_, displacement, row));
    sum += weighted_barrier(*patch_, row, g).value;
  });
  return sum;
}

void PatchLagrangian::shares(const Eigen::Matrix3Xd& displacement, Eigen::VectorXd& out) const {
  out.setOnes(static_cast<Eigen::Index>(patch_->inequalities.size()));
  patch_->inequalities.for_each([&](int number, const auto& row) {
    if (!has_multiplier(row)) return;
    const double g = value(row, corners_at(*patch_, displacement, row));
    out[number] = row.scale.share(g) - kLimitMargin;
  });
}

void PatchLagrangian::residuals(const Eigen::Matrix3Xd& displacement, Eigen::VectorXd& out) const {
  if (constraints_ == Constraints::kExact) {
    residuals_at(*patch_, displacement, out);
    return;
  }
  out.resize(static_cast<Eigen::Index>(patch_->equations.size()));
  patch_->equations.for_each([&]<class Row>(int e, const Row& row) {
    const RowPoints<Row::kArity> g = gradient(row, points_of(row, displacement));
    out[e] = 0.0;
    for (int k = 0; k < Row::kArity; ++k) {
      out[e] += g.col(k).dot(displaced(displacement, row.vertices[at(k)]));
    }
  });
}

}  // namespace planish
