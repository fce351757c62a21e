// SPDX-License-Identifier: MIT
#include "planish/projection/planarising.hpp"

#include "planish/mesh/adjacency.hpp"

namespace planish {

ProjectionResult planarise(const Mesh& mesh, const Planarising& how, const Progress& progress) {
  ProjectionOptions options;
  options.fairness_weight = how.fairness_weight;
  options.keep_shape = how.keep_shape;
  options.constraints = how.constraints;
  options.within = how.within;
  if (how.flat_within > 0.0) {
    options.tolerance = how.flat_within;
    options.no_flatter = true;
  }
  std::vector<int> pins;
  if (how.keep_boundary) pins = boundary_vertices(mesh);
  return project_to_planar(mesh, options, pins, progress);
}

bool is_flattened(const ProjectionResult& result, const Planarising& how) {
  const bool sound = how.keep_shape && !result.moved.empty() &&
                     result.report.status == SolveStatus::kToleranceNotMet;
  return result.report.usable() || sound;
}

}  // namespace planish
