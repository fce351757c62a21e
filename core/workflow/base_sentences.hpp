// SPDX-License-Identifier: MIT
/// What is said of the mesh that an edit starts from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit_run.hpp"

namespace planish::workflow {

/// Who edits a mesh that is not flat should know that more of it moved than the edit; nullopt if
/// the mesh was flat.
[[nodiscard]] std::optional<std::string> planarised_sentence(const FlatBase& base);

/// What became of the base before the edit: it was made flat, which moved what points stand on, or
/// made symmetric.
[[nodiscard]] std::vector<std::string> base_messages(const EditRun& run);

}  // namespace planish::workflow
