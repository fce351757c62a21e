// SPDX-License-Identifier: MIT
/// What JavaScript hands to the module for the workshop, as the core has it.
#pragma once

#include <emscripten/val.h>

#include <string>

#include "planish/fabrication/cutting_plan.hpp"

namespace planish::shop {

/// A design against its base.
struct ShopDesign {
  Mesh base, mesh;
  PanelNames names;
};

[[nodiscard]] ShopDesign to_design(const emscripten::val& design);
/// Of `design`.
[[nodiscard]] CuttingOptions to_cutting_options(const emscripten::val& options,
                                                const ShopDesign& design);

/// An answer with its `problem`; "" for none.
[[nodiscard]] emscripten::val refused(const std::string& sentence);

}  // namespace planish::shop
