// SPDX-License-Identifier: MIT
/// Panels parted until handles arrive: flat panels hold a handle, and more of them hold it less.
#pragma once

#include <functional>
#include <vector>

#include "planish/cuts/cut.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/symmetry/symmetry.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

/// What these cuts give, and what they cost.
struct SplitStanding {
  int lines = 0;              ///< each with its images; without a symmetry the number of cuts
  std::vector<Cut> cuts;      ///< lines between corners, in order; no point is added
  double handle_error = 0.0;  ///< model units
  int moved_vertices = 0;
  int remade_panels = 0;       ///< with a moved corner, or parts of a panel that was cut
  double sharpest_fold = 0.0;  ///< degrees, of panels with a moved corner
};

struct SplitOptions {
  int most_cuts = 4;  ///< ≥ 1; a line and its images are one
  /// 0 … 1, ends excluded: how far handles may be from their targets, as a share of the longest way
  /// of a handle.
  double within_handle = 0.05;
  int most_solves = 400;  ///< ≥ 1: then the best so far is given
  /// Told what would be in the curve as soon as it is found: none, then of each number of lines the
  /// best so far, which a better one of that number follows. Must not call back into the search.
  std::function<void(const SplitStanding&)> found = {};
};

/// The first rule that is broken, naming its field; nullopt if none.
[[nodiscard]] Refusal find_problem(const SplitOptions& options, const HandleEditOptions& edit,
                                   const EditTargets& targets);

struct SplitEdit {
  std::vector<Cut> cuts;    ///< of the last of the curve
  Mesh mesh;                ///< after them
  HandleEditResult result;  ///< of the edit of that mesh, bit for bit
  /// The best with so many lines, from none on; only what comes nearer than fewer lines do.
  std::vector<SplitStanding> curve;
  bool reached = false;  ///< the handles come within reach of their targets
  int solves = 0;
  SolveCost cost;  ///< of all of them
};

/// Solves the edit, and where handles stop short of their targets again with panels parted: lines
/// between corners of the panels at a handle, of those beside them, and of those that a limit
/// holds, the few best sets of cuts each with one more, until the handles arrive. More cuts are
/// taken only where handles then come nearer. Deterministic. [SPL-1]
/// @param targets with a symmetry closed under it: see with_images()
/// @param symmetry of the mesh, which has it within kSymmetric: lines are cut with their images,
/// and the edit is symmetric; null for none
/// @param progress of every solve; kStop ends with the best so far
[[nodiscard]] SplitEdit split_where_needed(const Mesh& mesh, const EditTargets& targets,
                                           const HandleEditOptions& edit,
                                           const SplitOptions& options,
                                           const MeshSymmetry* symmetry = nullptr,
                                           const Progress& progress = {});

}  // namespace planish
