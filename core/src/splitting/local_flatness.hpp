// SPDX-License-Identifier: MIT
/// A mesh made flat around some points alone.
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/splitting/fewer_panels.hpp"

namespace planish {

/// Where the points are that had to move, so that panels around `about` are flat and as sound as
/// they are in `mesh`; or why there are none such. Nothing beyond the reach is looked at.
/// @param about points in the middle
[[nodiscard]] std::variant<Positions, std::string> flat_around(const Mesh& mesh,
                                                               std::span<const int> about,
                                                               const NearbyOptions& options,
                                                               const Progress& progress);

}  // namespace planish
