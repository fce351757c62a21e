// SPDX-License-Identifier: MIT
/// What JavaScript hands to the module for the workshop, as the core has it.
#pragma once

#include <emscripten/val.h>

#include <exception>

#include "arrays.hpp"
#include "planish/fabrication/cutting_plan.hpp"

namespace planish::shop {

/// A design against its base.
struct ShopDesign {
  Mesh base, mesh;
  PanelNames names;
};

[[nodiscard]] ShopDesign to_design(const emscripten::val& design);
[[nodiscard]] CuttingOptions to_cutting_options(const emscripten::val& options,
                                                const ShopDesign& design);

/// What `make` gives; refused where there is no memory for it.
template <class Make>
emscripten::val in_memory(const Make& make) {
  try {
    return make();
  } catch (const std::exception&) {
    return refused("There is not enough memory for this in the browser.");
  }
}

}  // namespace planish::shop
