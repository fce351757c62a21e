// SPDX-License-Identifier: MIT
/// What keeps a mesh in place where a method has nothing else that does.
#pragma once

#include "planish/comparison/edit_task.hpp"

namespace planish::comparison {

/// Pins every boundary vertex that is not a handle; a mesh without boundary keeps its pins.
void hold_boundary(EditTask& task);

}  // namespace planish::comparison
