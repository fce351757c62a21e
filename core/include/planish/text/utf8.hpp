// SPDX-License-Identifier: MIT
/// Names come from file systems and files, which hold any bytes; what is written is UTF-8.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace planish {

/// Removes the first code point from `text`, which is not empty, and returns it; U+FFFD for what is
/// no UTF-8, of which one byte or the part that could have become a code point is removed.
[[nodiscard]] std::uint32_t take_code_point(std::string_view& text);

/// `text` with U+FFFD in place of what is no UTF-8.
[[nodiscard]] std::string as_utf8(std::string_view text);

/// `text` between the tags of HTML or SVG: as as_utf8() with & and < as entities.
[[nodiscard]] std::string markup_quoted(std::string_view text);

}  // namespace planish
