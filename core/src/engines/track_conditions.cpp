// SPDX-License-Identifier: MIT
/// What pulls at the points with tracks, and the conditions of a minimum there.
#include <algorithm>
#include <limits>

#include "engines/optimality.hpp"
#include "engines/working_set_newton.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

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

std::vector<CornerForce> WorkingSetNewton::corner_forces() const {
  std::vector<CornerForce> forces;
  const auto& offsets = model_.element_offsets[ConstraintKinds::index_of<PlanarPolygon>()];
  const auto& rows = patch_.equations.of<PlanarPolygon>();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double multiplier = state_.multipliers[static_cast<Eigen::Index>(k)];
    if (multiplier == 0.0) continue;
    const auto panel = std::upper_bound(offsets.begin(), offsets.end(), patch_.equation_ids[k]);
    const FourPoints slope = gradient(rows[k], corners_at(patch_, state_.displacement, rows[k]));
    for (std::size_t c = 0; c < rows[k].vertices.size(); ++c) {
      forces.push_back({static_cast<int>(panel - offsets.begin()) - 1,
                        patch_.vertices[at(rows[k].vertices[c])],
                        multiplier * slope.col(static_cast<Eigen::Index>(c))});
    }
  }
  return forces;
}

void WorkingSetNewton::judge_rests(const EditProblem& problem, double rest, Optimality& result) {
  judge(patch_, *problem.slides, track_forces(), rest, result);
}

}  // namespace planish
