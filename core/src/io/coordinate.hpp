// SPDX-License-Identifier: MIT
/// Coordinates in text files, with the sentence for one that is none.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planish {

/// Appends the first three numbers of `words` to `coordinates`. Returns what is wrong, without
/// the line, or an empty string; then the rest of the line stays in `words`.
[[nodiscard]] std::string take_point(std::string_view& words, std::vector<double>& coordinates);

}  // namespace planish
