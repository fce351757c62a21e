// SPDX-License-Identifier: MIT
/// What `offset` takes and tells.
#pragma once

#include <string>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/offset/mesh_offset.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

[[nodiscard]] std::vector<OptionRow> offset_option_rows();

/// Throws RequestError.
[[nodiscard]] OffsetOptions offset_options(const Request& request);

[[nodiscard]] Json offset_json(const Mesh& mesh, const MeshOffset& offset, double distance);

/// What whoever made the offset should know about it, one sentence each.
[[nodiscard]] std::vector<std::string> offset_sentences(const Mesh& mesh, const MeshOffset& offset);

[[nodiscard]] bool is_flat(const Mesh& mesh, const MeshOffset& offset);

}  // namespace planish::workflow
