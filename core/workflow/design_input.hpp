// SPDX-License-Identifier: MIT
/// Designs from files.
#pragma once

#include <optional>
#include <string>

#include "planish/design/design.hpp"
#include "planish/mesh/mesh.hpp"
#include "request.hpp"

namespace planish::workflow {

/// A design and the mesh that came with it.
struct OpenedDesign {
  Design design;
  std::optional<Mesh> base;
};

/// Opens a design from JSON, or from a GLB by its extension. Throws RequestError, also for a GLB
/// without a design.
[[nodiscard]] OpenedDesign open_design(const std::string& path);

/// Ends the command: `path` cannot be used, and why.
[[noreturn]] void refuse_file(const std::string& path, const std::string& sentence);

}  // namespace planish::workflow
