// SPDX-License-Identifier: MIT
#include "planish/projection/planarising.hpp"

#include "planish/mesh/adjacency.hpp"

namespace planish {

ProjectionOptions projection_options(const Planarising& how) {
  ProjectionOptions options;
  options.fairness_weight = how.fairness_weight;
  options.keep_shape = how.keep_shape;
  options.constraints = how.constraints;
  options.within = how.within;
  if (how.flat_within > 0.0) {
    options.tolerance = how.flat_within;
    options.no_flatter = true;
  }
  return options;
}

std::vector<int> projection_pins(const Mesh& mesh, const Planarising& how) {
  return how.keep_boundary ? boundary_vertices(mesh) : std::vector<int>();
}

ProjectionResult planarise(const Mesh& mesh, const Planarising& how, const Progress& progress) {
  return project_to_planar(mesh, projection_options(how), projection_pins(mesh, how), progress);
}

bool is_flattened(const ProjectionResult& result, const Planarising& how) {
  const bool sound = how.keep_shape && !result.moved.empty() &&
                     result.report.status == SolveStatus::kToleranceNotMet;
  return result.report.usable() || sound;
}

}  // namespace planish
