// SPDX-License-Identifier: MIT
#include "io/coordinate.hpp"

#include <cmath>
#include <optional>

#include "io/text_lines.hpp"
#include "planish/text/number.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

std::string wrong_number(std::string_view word) {
  if (word.find(',') != std::string_view::npos) {
    return "the coordinate " + quoted(word) +
           " has a comma; coordinates need a decimal point and spaces between them";
  }
  return quoted(word) + " is not a coordinate";
}

}  // namespace

std::string take_point(std::string_view& words, std::vector<double>& coordinates) {
  for (int c = 0; c < 3; ++c) {
    const std::string_view word = take_word(words);
    if (word.empty()) {
      return "a vertex needs 3 coordinates, here are " + std::to_string(c);
    }
    const std::optional<double> value = parse_number(word);
    if (!value) return wrong_number(word);
    if (!std::isfinite(*value)) return "the coordinate " + quoted(word) + " is not finite";
    coordinates.push_back(*value);
  }
  return "";
}

}  // namespace planish
