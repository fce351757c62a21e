// SPDX-License-Identifier: MIT
/// Keep-outs in the engines: their part of a patch's objective, of its system and of the conditions
/// at a minimum.
#include "engines/keep_out_terms.hpp"

#include <algorithm>
#include <limits>

#include "engines/optimality.hpp"
#include "engines/patch_system.hpp"
#include "engines/working_set_newton.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// A spring that pushes back a point that rests on a keep-out, where it goes deeper. [KEE-2]
Barrier resting_spring(double share) {
  constexpr double kStiffness = 1e5;
  const double force = kStiffness * std::min(share, 0.0);
  return {0.5 * force * std::min(share, 0.0), force, share < 0.0 ? kStiffness : 0.0};
}

/// What a row costs, and the first two derivatives by g. [LIM-2]
Barrier cost_of(const KeepOutRow& row, const Patch& patch, const Eigen::Matrix3Xd& displacement) {
  const Eigen::Vector3d place = patch.points.col(row.vertex) + displacement.col(row.vertex);
  const double share = row.share(place), by_value = row.scale.slope;
  const double weight = row.rests ? 1.0 : patch.limit_weight;
  const Barrier cost = row.rests ? resting_spring(share) : clamped_barrier(share);
  return {weight * cost.value, weight * cost.slope * by_value,
          weight * cost.curvature * by_value * by_value};
}

/// The conditions at points that planes may hold: these push, and never pull. [KEE-2]
void judge(const Patch& patch, const VertexSlides& slides, const std::vector<TrackForce>& forces,
           double rest, Optimality& result) {
  double unit = 0.0;
  for (const VertexTerm& term : patch.terms) unit = std::max(unit, 0.5 * term.norm_weight);
  if (unit == 0.0) unit = 0.5;
  for (const TrackForce& one : forces) {
    const bool moves = one.most <= 0.0 || one.displacement.norm() > rest;
    const double left = slides.left_of(one.vertex, one.force(moves)).norm();
    double& worst = moves ? result.stationarity : result.outside;
    worst = std::max(worst, moves ? left / unit : left / one.most - 1.0);
  }
}

}  // namespace

double with_keep_outs(double energy, const Patch& patch, const Eigen::Matrix3Xd& displacement) {
  for (const KeepOutRow& row : patch.keep_outs) energy += cost_of(row, patch, displacement).value;
  return energy;
}

void add_keep_out_gradient(const Patch& patch, const Eigen::Matrix3Xd& displacement,
                           Eigen::Matrix3Xd& out) {
  for (const KeepOutRow& row : patch.keep_outs) {
    const double slope = cost_of(row, patch, displacement).slope;
    if (slope != 0.0) out.col(row.vertex) += slope * row.normal;
  }
}

void PatchSystem::add_keep_outs(const PatchState& state) {
  for (const KeepOutRow& row : patch_->keep_outs) {
    const double curvature = cost_of(row, *patch_, state.displacement).curvature;
    if (curvature == 0.0) continue;
    const Eigen::Matrix3d block = curvature * row.normal * row.normal.transpose();
    const BlockSlot& slot = diagonal_[at(row.vertex)];
    double* const target = cholesky_.values().data() + slot.offset;
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) target[r + c * slot.stride] += block(r, c);
    }
  }
}

std::vector<TrackForce> WorkingSetNewton::track_forces() {
  std::vector<TrackForce> forces;
  if (patch_.slides.empty()) return forces;
  std::vector<Slide> slides;
  slides.swap(patch_.slides);  // put aside: what they would take is what is looked for
  system_.lagrangian().gradient_at(state_, std::numeric_limits<double>::infinity(), gradient_);
  slides.swap(patch_.slides);
  for (const Slide& slide : patch_.slides) {
    forces.push_back({patch_.vertices[at(slide.vertex)], state_.displacement.col(slide.vertex),
                      gradient_.col(slide.vertex),
                      0.5 * patch_.terms[at(slide.vertex)].norm_weight});
  }
  return forces;
}

void WorkingSetNewton::judge_rests(const EditProblem& problem, double rest, Optimality& result) {
  judge(patch_, *problem.slides, track_forces(), rest, result);
}

}  // namespace planish
