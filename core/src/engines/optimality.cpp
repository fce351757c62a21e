// SPDX-License-Identifier: MIT
#include "engines/optimality.hpp"

#include <algorithm>

#include "planish/index.hpp"

namespace planish {
namespace {

/// What is left of a pull on a vertex with supports.
Eigen::Vector3d along_its_track(const Patch& patch, int vertex, const Eigen::Vector3d& pull) {
  const auto found = std::lower_bound(patch.slides.begin(), patch.slides.end(), vertex,
                                      [](const Slide& slide, int v) { return slide.vertex < v; });
  if (found == patch.slides.end() || found->vertex != vertex) return pull;
  return found->track.along * pull;
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

}  // namespace planish
