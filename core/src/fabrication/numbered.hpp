// SPDX-License-Identifier: MIT
/// Names of things that are made: letters and a number.
#pragma once

#include <string>
#include <string_view>

namespace planish {

/// "P-0001" for index 0: the number from 1, four digits or more.
[[nodiscard]] inline std::string numbered(std::string_view letters, int index) {
  std::string digits = std::to_string(index + 1);
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  return std::string(letters) + "-" + digits;
}

}  // namespace planish
