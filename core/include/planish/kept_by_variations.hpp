// SPDX-License-Identifier: MIT
/// What variations around an edit leave as the edit has it.
#pragma once

#include <vector>

#include "planish/constraints/kept_kinds.hpp"
#include "planish/handle_edit.hpp"
#include "planish/mesh.hpp"
#include "planish/point_support.hpp"

namespace planish {

struct KeptByVariations {
  std::vector<int> held = {};     ///< vertices that no variation moves
  KeptKinds kinds = KeptKinds();  ///< kept to first order, and exactly once a variation is exact
  /// About the base: their points go along them, to first order, and are exactly there once a
  /// variation is exact. Those that have not left their place on an outline or polyline stay there.
  /// kNewton only. [SUP-6]
  std::vector<PointSupport> supports = {};
};

/// Of an edit of `mesh`: vertices that it holds, and points that rest on a keep-out in the base,
/// stay where the edit put them. O(n).
[[nodiscard]] KeptByVariations kept_by_variations(const Mesh& mesh, const EditTargets& targets,
                                                  const HandleEditOptions& options);

}  // namespace planish
