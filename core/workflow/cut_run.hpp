// SPDX-License-Identifier: MIT
/// What `cut` takes and tells.
#pragma once

#include <string>
#include <vector>

#include "planish/cuts/cut_mesh.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

[[nodiscard]] std::vector<OptionRow> cut_option_rows();

/// The cuts that options ask for, in the order in which they were given. Throws RequestError.
[[nodiscard]] std::vector<Cut> asked_cuts(const Request& request);

/// The cuts of --cut, in their order; none is none. Throws RequestError.
[[nodiscard]] std::vector<Cut> cuts_before_edit(const Request& request);

/// Each cut with what it made, the panels that are parts of others, and where added points stand.
void add_cuts(Json& json, const CutMesh& result);

/// The sentence that points belong to no panel any more; nullopt where none do.
[[nodiscard]] std::optional<std::string> loose_points_sentence(const Mesh& before,
                                                               const Mesh& after);

}  // namespace planish::workflow
