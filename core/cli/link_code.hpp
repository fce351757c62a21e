// SPDX-License-Identifier: MIT
/// A link as a QR code, the same as the page draws.
#pragma once

#include <string>

#include "planish/fabrication/labels.hpp"

namespace planish::cli {

/// @param link "" for none
[[nodiscard]] LinkCode make_link_code(const std::string& link);

}  // namespace planish::cli
