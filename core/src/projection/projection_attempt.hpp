// SPDX-License-Identifier: MIT
/// (8) without a bound on the panels' shape, or with its weighted distance and the bound.
#pragma once

#include <optional>

#include "projection/projection_task.hpp"

namespace planish {

/// Whatever becomes of the panels' shape. @returns positions, 3 × n; the rest is in `result`
[[nodiscard]] Positions project_freely(const ProjectionTask& task, const Progress& progress,
                                       ProjectionResult& result);

/// The weighted distance with the bound on every panel's shape; nullopt where that does not end
/// with panels that are all flat and sound.
[[nodiscard]] std::optional<ProjectionResult> project_in_shape(const ProjectionTask& task,
                                                               const Progress& progress);

}  // namespace planish
