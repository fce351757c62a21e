// SPDX-License-Identifier: MIT
/// What a projection makes of a mesh, perhaps split or with fewer types, and tells of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planish/projection/projection.hpp"
#include "planish/repetition/fewer_types.hpp"
#include "planish/splitting/split_until_flat.hpp"
#include "report.hpp"
#include "request.hpp"

namespace planish::workflow {

[[nodiscard]] OptionRow hybrid_option_row();

/// A projection, perhaps of the mesh with panels parted, or with fewer types.
struct ProjectedMesh {
  Mesh mesh;  ///< as given, parted where that was asked for
  ProjectionResult result;
  std::optional<HybridMesh> hybrid;  ///< with --split, its result apart
  std::optional<FewerTypes> fewer;   ///< with --move
};

/// run_projection(), or, with --split, split_until_flat(), or, with --move, find_fewer_types().
/// Throws RequestError.
[[nodiscard]] ProjectedMesh make_flat(const Mesh& mesh, const Request& request,
                                      const ProjectionOptions& options, const Mesh* reference,
                                      const Progress& progress);

/// The report of `project`. @param reference as for make_flat()
[[nodiscard]] Json projected_json(const ProjectedMesh& projected, const Mesh* reference,
                                  const ProjectionOptions& options);

/// @param report of projected_json()
[[nodiscard]] std::vector<std::string> projected_messages(const ProjectedMesh& projected,
                                                          const Json& report,
                                                          const ProjectionOptions& options,
                                                          const Request& request);

}  // namespace planish::workflow
