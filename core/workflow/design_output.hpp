// SPDX-License-Identifier: MIT
/// What `edit`, `explore` and `replay` leave behind so that it can be done again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit_run.hpp"
#include "planish/design/design.hpp"
#include "planish/io/gltf.hpp"
#include "request.hpp"

namespace planish::workflow {

/// The design of a run. @param shape 3 × n, what came out
[[nodiscard]] Design make_design(const EditRun& run, std::vector<DesignVariation> variations,
                                 const Positions& shape);

/// The text of a design without the file that it came from: a GLB holds the base itself. With it
/// where there are cuts, since that base is what they left.
[[nodiscard]] std::string design_for_glb(Design design);

/// `shape` (3 × n) in the format of `name`'s extension; a GLB also holds base, design and
/// variations.
[[nodiscard]] std::string edit_bytes(const std::string& name, const EditRun& run,
                                     const Positions& shape, const Design& design,
                                     std::optional<GlbVariations> variations = {});

}  // namespace planish::workflow
