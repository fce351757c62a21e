// SPDX-License-Identifier: MIT
/// What the workshop gets: a mesh, or a design with its base.
#pragma once

#include <string>

#include "arguments.hpp"
#include "types_run.hpp"

namespace planish::cli {

/// The only positional word, with --model-unit, --tolerance and --against where a command takes
/// them. Throws RequestError.
[[nodiscard]] ShopInput load_shop_input(const Arguments& arguments);

/// Throws UsageError where the name of a zip says that it is in another format, as a picture.
/// @param what is written, with its article
void check_zip_name(const std::string& path, const std::string& what);

}  // namespace planish::cli
