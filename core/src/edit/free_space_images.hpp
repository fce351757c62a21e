// SPDX-License-Identifier: MIT
#pragma once

#include "planish/obstacles/keep_out.hpp"
#include "planish/symmetry/symmetry.hpp"

namespace planish {

/// What keep-outs and all their images leave free, each of them once.
[[nodiscard]] FreeSpace with_images(const FreeSpace& free, const MeshSymmetry& symmetry);

}  // namespace planish
