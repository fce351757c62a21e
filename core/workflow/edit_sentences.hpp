// SPDX-License-Identifier: MIT
/// What is said of an edit that ran, a sentence each; nullopt where there is nothing to say.
#pragma once

#include <optional>
#include <string>

#include "edit_run.hpp"

namespace planish::workflow {

/// That --fewest held nothing, or how few panels it left; nullopt where few were not asked for.
/// @param report of edit_json()
[[nodiscard]] std::optional<std::string> fewest_sentence(const EditRun& run, const Json& report);

/// Who edits a mesh that is not flat should know that more of it moved than the edit; nullopt if
/// the mesh was flat.
[[nodiscard]] std::optional<std::string> planarised_sentence(const FlatBase& base);

/// That making the base flat moved what points stand on, and what keeps it where it is; nullopt if
/// it did not.
[[nodiscard]] std::optional<std::string> moved_support_sentence(const EditRun& run);

/// A handle that gets noticeably less far than it is pulled, with --hard any less far, the worst of
/// them, and what holds it; nullopt if none does, or where outcome_sentence() has more to say.
[[nodiscard]] std::optional<std::string> shortfall_sentence(const EditRun& run);

/// Whether --hard was asked for and a handle is not at its target.
[[nodiscard]] bool misses_hard_handle(const EditRun& run);

/// Whether more panels are to be made again than --fewest N allows.
[[nodiscard]] bool misses_most_panels(const EditRun& run);

/// How far the surface moves and how far joints slide along it, where that is noticeably further or
/// has a limit; nullopt otherwise.
/// @param report of edit_json() or exploration_json()
[[nodiscard]] std::optional<std::string> motion_sentence(const EditRun& run, const Json& report);

/// Which limits of --bound panels of the base break already, and how many do, where that holds an
/// edit back that stops short of what was asked for; nullopt otherwise.
[[nodiscard]] std::optional<std::string> broken_limits_sentence(const EditRun& run);

/// That --bound slide stops a handle on its way along the surface, the one asked to go furthest;
/// nullopt where no target is beyond that limit.
[[nodiscard]] std::optional<std::string> sliding_target_sentence(const EditRun& run);

/// That the base was made symmetric first, and by how much; nullopt where it was.
[[nodiscard]] std::optional<std::string> evened_sentence(const EditRun& run);

}  // namespace planish::workflow
