// SPDX-License-Identifier: MIT
/// Nodes that must be made again: part of find_remake().
#pragma once

#include <vector>

#include "planish/fabrication/remake.hpp"

namespace planish {

/// @param panels of `mesh` against `base`, as find_remake() has them. [FAB-3]
[[nodiscard]] std::vector<NodeChange> compare_nodes(const Mesh& base, const Mesh& mesh,
                                                    const std::vector<PanelChange>& panels);

}  // namespace planish
