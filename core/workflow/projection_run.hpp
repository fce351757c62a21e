// SPDX-License-Identifier: MIT
/// What `project` takes, does and tells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/projection/projection.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

[[nodiscard]] std::vector<OptionRow> projection_option_rows();

/// Throws RequestError.
[[nodiscard]] ProjectionOptions projection_options(const Request& request);

/// Points that must not move. Throws UsageError, also for supports that are none of `mesh`.
[[nodiscard]] std::vector<int> projection_pins(const Mesh& mesh, const Request& request,
                                               const ProjectionOptions& options);

/// @param reference the mesh that --reference names, or null
/// Throws RequestError where it has other faces than `mesh`.
[[nodiscard]] ProjectionResult run_projection(const Mesh& mesh, const Request& request,
                                              const ProjectionOptions& options,
                                              const Mesh* reference, const Progress& progress);

/// `mesh` with what moved in place, 3 × n.
[[nodiscard]] Positions projected(const Mesh& mesh, const ProjectionResult& result);

/// @param base what supports are about: the reference, or `mesh`
[[nodiscard]] Json projection_json(const Mesh& mesh, const Mesh& base,
                                   const ProjectionResult& result,
                                   const ProjectionOptions& options);

/// The sentence that another problem than (8) had to serve, and why; nullopt where it did not.
[[nodiscard]] std::optional<std::string> confined_sentence(const ProjectionResult& result);

/// What to do where shape and flatness cannot both be had; nullopt where they can.
[[nodiscard]] std::optional<std::string> not_flat_sentence(const ProjectionResult& result,
                                                           const ProjectionOptions& options,
                                                           const Request& request);

/// The sentence that a mesh lost half or more of its height, or rise, and what keeps it; nullopt
/// where it did not.
[[nodiscard]] std::optional<std::string> lost_height_sentence(const Mesh& mesh,
                                                              const ProjectionResult& result);

/// That points move by more than a hundredth of the mesh's size, and what stays nearer; nullopt
/// where they do not.
[[nodiscard]] std::optional<std::string> moved_far_sentence(const Mesh& mesh,
                                                            const ProjectionResult& result,
                                                            const Request& request);

}  // namespace planish::workflow
