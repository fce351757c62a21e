// SPDX-License-Identifier: MIT
/// What variations around an edit leave as the edit has it.
#pragma once

#include <memory>
#include <vector>

#include "planish/constraints/kept_kinds.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/supports/point_support.hpp"
#include "planish/symmetry/symmetry.hpp"

namespace planish {

struct KeptByVariations {
  std::vector<int> held = {};     ///< vertices that no variation moves
  KeptKinds kinds = KeptKinds();  ///< kept to first order, and exactly once a variation is exact
  /// About the base: their points go along them, to first order, and are exactly there once a
  /// variation is exact. Those that have not left their place on an outline or polyline stay there.
  /// kNewton only. [SUP-6]
  std::vector<PointSupport> supports = {};
  /// Of the base, the edit and all of the above: variations have it, too. Null: none. [SYM-3]
  std::shared_ptr<const MeshSymmetry> symmetry = nullptr;
};

/// What variations of an edit of `mesh` keep: vertices that it holds, and points that rest on a
/// keep-out in the base, stay where the edit put them. O(n).
/// @param targets with all images, where there is a symmetry
[[nodiscard]] KeptByVariations kept_by_variations(
    const Mesh& mesh, const EditTargets& targets, const HandleEditOptions& options,
    std::shared_ptr<const MeshSymmetry> symmetry = nullptr);

}  // namespace planish
