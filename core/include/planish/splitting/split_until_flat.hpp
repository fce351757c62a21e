// SPDX-License-Identifier: MIT
/// Panels parted until the mesh becomes flat: a hybrid of polygons and smaller ones, as roofs are
/// built that no flat panels fit.
#pragma once

#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/projection/projection.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

struct HybridOptions {
  int most_panels = 0;        ///< ≥ 1: that are parted
  int most_projections = 40;  ///< ≥ 1: then the fewest so far are given
};

[[nodiscard]] Refusal find_problem(const HybridOptions& options);

/// What the mesh becomes with so many panels parted.
struct HybridStanding {
  int panels = 0;         ///< that are parted
  int failing_faces = 0;  ///< of the parted mesh; 0: it is flat
  double rms_move = 0.0;  ///< model units
  double max_move = 0.0;  ///< model units
};

struct HybridMesh {
  CutMesh cut;              ///< lines between corners: no point is added; positions as given
  ProjectionResult result;  ///< of the parted mesh, bit for bit
  int panels = 0;           ///< that are parted
  /// By the number of panels, from none on; only what leaves fewer bent than fewer panels do, or
  /// leaves none either and moves points less (rms_move).
  std::vector<HybridStanding> curve;
  int projections = 0;   ///< that were tried
  bool reached = false;  ///< flat, and sound where the projection keeps shapes
};

/// Projects the mesh, and where that is not flat again with panels parted, by halves of how many,
/// until fewer are not flat: those that stayed bent, where they are few; then far from each other,
/// the more bent first. Quads part along the shorter diagonal, larger panels in half, or, where
/// that is not enough even for most_panels, into triangles. Where even that is not flat the state
/// with the fewest bent panels is given. Deterministic. [SPL-2]
/// @param options as project_to_planar() takes them, without a history
/// @param pins vertices that must not move
/// @param progress of every projection; kStop ends with the best so far
[[nodiscard]] HybridMesh split_until_flat(const Mesh& mesh, const ProjectionOptions& options,
                                          const std::vector<int>& pins, const HybridOptions& hybrid,
                                          const Progress& progress = {});

}  // namespace planish
