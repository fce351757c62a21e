// SPDX-License-Identifier: MIT
/// What keeps a mesh in place where a method has nothing else that does.
#pragma once

#include "planish/comparison/edit_task.hpp"

namespace planish::comparison {

/// `task` without a term that keeps points at rest, and with every boundary vertex pinned that is
/// not a handle; a mesh without boundary keeps its pins.
[[nodiscard]] EditTask with_held_boundary(EditTask task);

}  // namespace planish::comparison
