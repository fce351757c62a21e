// SPDX-License-Identifier: MIT
/// What a table says of an outline.
#pragma once

#include "fabrication/table_writer.hpp"
#include "planish/fabrication/flat_panel.hpp"

namespace planish {

/// Lengths of its sides, its angles in degrees, its area, its perimeter and the rectangle around
/// it.
void add_measures(TableWriter& table, const Outline& outline);

}  // namespace planish
