// SPDX-License-Identifier: MIT
/// What the workshop gets: a mesh, or a design with its base.
#pragma once

#include <optional>
#include <string>

#include "arguments.hpp"
#include "planish/mesh.hpp"

namespace planish::cli {

/// What is cut, and what it is compared with.
struct ShopInput {
  Mesh mesh;
  std::optional<Mesh> base;
  std::string model_unit;
  double tolerance = 1e-6;  ///< mm/m, up to which a panel is flat
  std::string name = "";    ///< of its file, without folder and extension

  [[nodiscard]] const Mesh* base_or_null() const { return base ? &*base : nullptr; }
};

/// The only positional word, with --model-unit, --tolerance and --against where a command takes
/// them. Throws CommandError.
[[nodiscard]] ShopInput load_shop_input(const Arguments& arguments);

}  // namespace planish::cli
