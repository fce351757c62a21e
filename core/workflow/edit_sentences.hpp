// SPDX-License-Identifier: MIT
/// What is said of an edit that ran.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit_run.hpp"

namespace planish::workflow {

/// What became of the edit.
/// @param report of edit_json() or exploration_json() @param variation what is said of one, too
[[nodiscard]] std::vector<std::string> edit_messages(
    const EditRun& run, const Json& report, const std::vector<std::string>& variation = {});

/// Whether --hard was asked for and a handle is not at its target.
[[nodiscard]] bool misses_hard_handle(const EditRun& run);

/// Whether more panels are to be made again than --fewest N allows.
[[nodiscard]] bool misses_most_panels(const EditRun& run);

}  // namespace planish::workflow
