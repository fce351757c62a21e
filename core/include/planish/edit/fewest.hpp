// SPDX-License-Identifier: MIT
/// An edit that makes few panels again: points are held as long as the handles still arrive.
#pragma once

#include <string_view>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/symmetry/symmetry.hpp"

namespace planish {

/// What is to be few.
enum class FewestOf {
  kPanels,  ///< panels with a corner that moves
  kPoints,  ///< points that move
};

struct FewestOptions {
  FewestOf of = FewestOf::kPanels;
  /// 0 … 1, ends excluded: how far handles may be from their targets, as a share of the longest way
  /// of a handle.
  double within_handle = 0.05;
  /// With kPanels: no more points are held once at most so many panels have a corner that moves, so
  /// that folds stay gentle; 0: as few as can be.
  int most_panels = 0;
  int most_solves = 1000;  ///< ≥ 1: then the best so far is given, not minimal
};

/// The first rule that is broken, naming its field; nullopt if none.
[[nodiscard]] Refusal find_problem(const FewestOptions& options, const HandleEditOptions& edit,
                                   const EditTargets& targets);

/// The limit on corners with which panels can be built.
inline constexpr std::string_view kBuildableCorners = "angle=20:170";

/// What keeps few panels such that they can be built: corners from 20° to 170°, edges from 0.2 to 5
/// mean edges, each where `stated` has no limit of its name. Without them a panel that takes up the
/// whole move becomes a sliver.
[[nodiscard]] std::vector<StatedLimit> buildable_limits(const Mesh& mesh,
                                                        const std::vector<StatedLimit>& stated);

struct FewestEdit {
  HandleEditResult result;
  /// Held beside the pins of the targets, ascending: the edit with all of them as pins is `result`,
  /// bit for bit.
  std::vector<int> held;
  int panels_before = 0;  ///< with a moved corner, where nothing is held
  int panels = 0;         ///< with a moved corner, in `result`
  /// Whether the handles come within reach of their targets where nothing is held. If not, nothing
  /// is held.
  bool reached = false;
  /// For each point that moves, handles excepted: the edit with that point held, too, under a
  /// symmetry with its images, was solved, and the handles did not arrive. [FEW-1]
  bool minimal = false;
  int solves = 0;
};

/// Solves the edit, then again and again with more points held: those of the panels that move
/// least, as many at once as can be, at last each point by itself. Limits and shapes hold as in any
/// edit. O(moved points) solves on ever smaller patches.
/// @param targets under a symmetry with all images, see with_images()
/// @param symmetry of the edit: points are held with their images; or null
/// @param progress of every solve; kStop ends with the best so far
[[nodiscard]] FewestEdit find_fewest(const Mesh& mesh, HandleEditSolver& solver,
                                     const EditTargets& targets, const FewestOptions& options,
                                     const MeshSymmetry* symmetry = nullptr,
                                     const Progress& progress = {});

/// A fewest edit, and the options that its result is the edit of.
struct BuildableFewest {
  FewestEdit edit;
  HandleEditOptions options;
};

/// find_fewest() within buildable_limits() beside those of `options`; without them where the
/// handles arrive only so.
[[nodiscard]] BuildableFewest find_buildable_fewest(const Mesh& mesh,
                                                    const HandleEditOptions& options,
                                                    const EditTargets& targets,
                                                    const FewestOptions& fewest,
                                                    const MeshSymmetry* symmetry = nullptr,
                                                    const Progress& progress = {});

}  // namespace planish
