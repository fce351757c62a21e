// SPDX-License-Identifier: MIT
/// The whole structure as a picture: which panel is where, and what must be made again.
#pragma once

#include <string>

#include "planish/fabrication/cutting_plan.hpp"

namespace planish {

/// SVG: the panels seen along the mean of their normals, with their names, and beside it those that
/// show their back from there, seen from the other side. Not to scale for panels that lie aslant.
[[nodiscard]] std::string write_assembly_map(const CuttingPlan& plan);

}  // namespace planish
