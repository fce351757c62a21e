// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace planish {

/// Whether brackets of `json` nest more than `limit` deep, found without recursion, so that a
/// parser that recurses can be kept from text that would exhaust its stack.
[[nodiscard]] bool is_json_deeper_than(std::string_view json, int limit);

}  // namespace planish
