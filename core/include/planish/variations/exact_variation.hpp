// SPDX-License-Identifier: MIT
/// What a slider shows, made exact within everything that the edit keeps.
#pragma once

#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/edit/kept_by_variations.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/problem/solve_report.hpp"
#include "planish/projection/projection.hpp"

namespace planish {

/// A shape that the sliders show. Positions are 3 × n, model units; the three outlive their use.
struct ShownVariation {
  const Mesh& base;
  const Positions& edited;  ///< p⁺ of the family: exact, within the edit's limits
  const Positions& shown;
};

/// (8) with the base as its history, to the edit's tolerance and by its engine. Where the result
/// exceeds a limit of the edit, or has a panel spoilt that the edit had not although the edit keeps
/// shape, the variation comes back towards the edit until neither is so: by bisection of the way,
/// so it is the furthest of those tried, and the edit itself if none of them holds. Then the status
/// is kNearestConfined, because of kStatedLimits or kSpoiltByVariation, and the report names the
/// panels that would have exceeded each limit, or would be spoilt. [PRO-9]
/// @param fairness_weight α_f ≥ 0
/// The supports of `keeps` hold as they do in edits.
/// @returns moves from `shown`
[[nodiscard]] ProjectionResult make_exact(const ShownVariation& variation,
                                          const HandleEditOptions& options, double fairness_weight,
                                          const KeptByVariations& keeps,
                                          const Progress& progress = {});

}  // namespace planish
