// SPDX-License-Identifier: MIT
/// Rows of mobility as plain JavaScript objects, one shape for the page and the npm package.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "planish/mobility/mobility_meter.hpp"

namespace planish {

/// An array of {vertex, direction, distance, limit, remake, sharpestFold}.
[[nodiscard]] emscripten::val to_value(const std::vector<MobilityRow>& rows);

}  // namespace planish
