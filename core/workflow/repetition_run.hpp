// SPDX-License-Identifier: MIT
/// What `--types`, `--move` and `--mirrored` of a projection take, do and tell.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/projection/projection.hpp"
#include "planish/repetition/fewer_types.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

[[nodiscard]] std::vector<OptionRow> repetition_option_rows();

/// Whether panels are to become alike: --within is then how much.
[[nodiscard]] bool asks_for_fewer_types(const Request& request);

/// @param options of the same request @param pins vertices that must not move
/// Throws RequestError, also for a mesh that is not flat.
[[nodiscard]] FewerTypes run_fewer_types(const Mesh& mesh, const Request& request,
                                         const ProjectionOptions& options,
                                         const std::vector<int>& pins, const Progress& progress);

/// `fewer` as a projection that moved its points.
[[nodiscard]] ProjectionResult projection_of(const Mesh& mesh, const FewerTypes& fewer);

[[nodiscard]] Json fewer_types_json(const Mesh& mesh, const FewerTypes& fewer);

/// How many types became how many, within what, and how far points move for it.
[[nodiscard]] std::string fewer_types_sentence(const Mesh& mesh, const FewerTypes& fewer);

}  // namespace planish::workflow
