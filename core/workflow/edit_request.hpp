// SPDX-License-Identifier: MIT
/// What an edit is asked for, read once for every door.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "planish/edit/fewest.hpp"
#include "planish/edit/handle_edit.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/splitting/split_where_needed.hpp"
#include "planish/symmetry/symmetry.hpp"
#include "request.hpp"
#include "type_change.hpp"

namespace planish::workflow {

/// What an edit is asked for; whether its mesh has the vertices is seen when that is there.
struct EditRequest {
  HandleEditOptions options;
  std::string unit;       ///< of the model
  std::vector<Cut> cuts;  ///< before the edit, in this order
  std::optional<StatedSymmetry> symmetry;
  std::optional<FewestOptions> fewest;
  std::optional<SplitOptions> splits;
  bool fair = false;  ///< with the limits that cost the handles nothing
  std::optional<TypeCounting> types;
  EditTargets targets = {};
  std::vector<bool> relative = {};  ///< of each handle: its target is a way from the base
};

/// Throws UsageError; RequestError where a file that is named cannot be used.
[[nodiscard]] EditRequest edit_request(const Request& request);

/// Handles, pins and supports of `asked` on `base`. Throws UsageError.
/// @param cut what made `base`: its added points go with the supports that are checked; or null
[[nodiscard]] EditTargets edit_targets(const EditRequest& asked, const Mesh& base,
                                       const CutMesh* cut = nullptr);

}  // namespace planish::workflow
