// SPDX-License-Identifier: MIT
/// How an opened mesh becomes flat: (8) without a history, between the nearest flat mesh and a fair
/// one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planish/constraints/kept_constraint.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/projection/projection.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

struct Planarising {
  /// α_f ≥ 0. 0: as close as possible, which crumples smooth meshes. Higher: smoother, and farther
  /// away; from 1 to 100 little changes on most meshes.
  double fairness_weight = 10.0;
  bool keep_boundary = false;  ///< points on boundary edges stay
  bool keep_shape = true;      ///< ProjectionOptions::keep_shape
  /// What the mesh becomes beside flat, as HandleEditOptions::constraints.
  std::vector<KeptConstraint> constraints = {};
  double within = 0.0;  ///< ProjectionOptions::within
  /// mm/m, ≥ 0: panels may stay that far out of flat, and change as little as that needs; 0:
  /// exactly flat.
  double flat_within = 0.0;

  friend bool operator==(const Planarising&, const Planarising&) = default;
};

/// What designs of the time before there was a choice mean.
inline const Planarising kNearestFlat{0.0, false, false, {}, 0.0, 0.0};

[[nodiscard]] Refusal find_problem(const Planarising& how);

// `how` as project_to_planar() takes it.
[[nodiscard]] ProjectionOptions projection_options(const Planarising& how);
[[nodiscard]] std::vector<int> projection_pins(const Mesh& mesh, const Planarising& how);

/// kToleranceNotMet with keep_shape: the panels' shape does not allow more; the positions are sound
/// and as flat as was found.
[[nodiscard]] ProjectionResult planarise(const Mesh& mesh, const Planarising& how,
                                         const Progress& progress = {});

/// Whether `result` takes the place of the mesh: every panel is flat, or as flat as its shape
/// allows. Edits ask for more: a mesh that is flat to their tolerance.
[[nodiscard]] bool is_flattened(const ProjectionResult& result, const Planarising& how);

}  // namespace planish
