// SPDX-License-Identifier: MIT
/// Pieces of the sentences that readers and checks say.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace planish {

/// "1 vertex" or "5 vertices".
[[nodiscard]] std::string count_text(std::size_t count, std::string_view one,
                                     std::string_view many);

/// `text` cut after `longest` characters, with anything unprintable shown as '?'.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest);

/// `text` in quotes: cut after 24 characters, with anything unprintable shown as '?'.
[[nodiscard]] std::string quoted(std::string_view text);

/// "line 7: " + what.
[[nodiscard]] std::string line_text(int line, std::string_view what);

/// `value` for reading, not for storing: 6 digits.
[[nodiscard]] std::string number_text(double value);

}  // namespace planish
