// SPDX-License-Identifier: MIT
/// What the workshop gets: a mesh, or a design with its base.
#pragma once

#include <optional>
#include <string>

#include "arguments.hpp"
#include "planish/constraints/planar_polygon.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish::cli {

/// What is cut, and what it is compared with.
struct ShopInput {
  Mesh mesh;
  std::optional<Mesh> base;
  std::string model_unit;
  double tolerance = PlanarPolygon::kTolerance;  ///< mm/m, up to which a panel is flat
  /// Of its file, without folder and extension. Given a value since gcc asks for one in aggregates.
  std::string name = "";  // NOLINT(readability-redundant-string-init)

  [[nodiscard]] const Mesh* base_or_null() const { return base ? &*base : nullptr; }
};

/// What --model-unit and --tolerance say of `input`, where they are given. Throws CommandError.
void read_shop_options(const Arguments& arguments, ShopInput& input);

/// The only positional word, with --model-unit, --tolerance and --against where a command takes
/// them. Throws CommandError.
[[nodiscard]] ShopInput load_shop_input(const Arguments& arguments);

/// In small letters, without its point; "" if the name has none.
[[nodiscard]] std::string extension_of(const std::string& path);

/// Throws CommandError where the name of a zip says that it is in another format, as a picture.
/// @param what is written, with its article
void check_zip_name(const std::string& path, const std::string& what);

}  // namespace planish::cli
