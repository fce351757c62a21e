// SPDX-License-Identifier: MIT
/// What an edit starts from after cuts: the mesh, its symmetry, and what points stand on.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/supports/point_support.hpp"
#include "planish/symmetry/symmetry.hpp"

namespace planish {

/// `flat` after `cuts`; or one sentence that says why it cannot be cut so.
/// @param symmetry of `flat`; set to that of the mesh after the cuts, which must have it
/// @param tolerance mm/m
[[nodiscard]] std::variant<CutMesh, std::string> cut_base(const Mesh& flat,
                                                          const std::vector<Cut>& cuts,
                                                          std::optional<MeshSymmetry>& symmetry,
                                                          double tolerance);

/// `supports` with the points that cuts added: one on a side whose ends are both listed stands
/// where they do, and in its place along a polyline. Those of `boundary` and `all` need none.
[[nodiscard]] std::vector<PointSupport> supports_after_cuts(
    const std::vector<PointSupport>& supports, const CutMesh& cut);

}  // namespace planish
