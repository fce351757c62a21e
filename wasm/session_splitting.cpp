// SPDX-License-Identifier: MIT
/// Panels of a session's base parted for what a solve asks: where handles stop short, and until the
/// mesh is flat.
#include <string>
#include <utility>
#include <variant>

#include "session.hpp"

namespace planish {

std::variant<SplitEdit, std::string> Session::split_where_needed(EditTargets targets,
                                                                 const SplitOptions& options) {
  if (const Refusal refusal = begin_edit(targets)) return *refusal;
  if (const Refusal problem = find_problem(options, options_, targets)) return *problem;
  const DesignSteps steps = steps_of(targets);
  if (const Refusal refusal = find_image_problem(steps)) return *refusal;
  return planish::split_where_needed(base_, steps.images(), options_, options, symmetry_.get(),
                                     progress_);
}

Refusal Session::split_until_flat(const Planarising& how, int most_panels) {
  if (const auto problem = find_problem(how)) return *problem;
  if (cut_) return "Panels are split before any cut: take the cuts back first.";
  HybridOptions hybrid;
  hybrid.most_panels = most_panels;
  if (const auto problem = find_problem(hybrid)) return *problem;
  Mesh opened = as_opened();
  HybridMesh found = planish::split_until_flat(opened, projection_options(how),
                                               projection_pins(opened, how), hybrid, progress_);
  if (!is_flattened(found.result, how)) {
    return std::to_string(found.result.failing_faces.size()) + " panels stay bent, with " +
           std::to_string(found.panels) + " split; the mesh is as it was.";
  }
  hybrid_ = {found.panels, static_cast<int>(found.result.failing_faces.size()),
             found.result.rms_move, found.result.max_move};
  Mesh mesh = std::move(found.cut.mesh);
  mesh.positions(Eigen::all, found.result.moved) = found.result.moved_positions;
  adopt(std::move(mesh), warnings_);
  before_planarising_ = std::move(opened.positions);
  return std::nullopt;
}

}  // namespace planish
