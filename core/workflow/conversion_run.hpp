// SPDX-License-Identifier: MIT
/// What is mended in a mesh on its way to another format: its points joined, its panels turned, its
/// triangles joined to quads.
#pragma once

#include <string>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "request.hpp"

namespace planish::workflow {

[[nodiscard]] std::vector<OptionRow> conversion_option_rows();

struct Converted {
  Mesh mesh;
  std::vector<std::string> messages;  ///< how much was joined and turned
};

/// Points are joined first, then panels turned, then triangles joined. Throws RequestError.
[[nodiscard]] Converted run_conversion(Mesh mesh, const Request& request);

}  // namespace planish::workflow
