// SPDX-License-Identifier: MIT
#include "text/sentence.hpp"

#include <cmath>

#include "planish/text/number.hpp"

namespace planish {

std::string count_text(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string result;
  for (const char c : text.substr(0, longest)) result += (c < ' ' || c > '~') ? '?' : c;
  if (text.size() > longest) result += "…";
  return result;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 24;
  std::string result = "\"";
  result += printable(text, kLongest);
  return result += '"';
}

std::string line_text(int line, std::string_view what) {
  std::string text = "line ";
  text += std::to_string(line);
  text += ": ";
  return text += what;
}

std::string number_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::string text;
  append_number(text, value, 6);
  return text;
}

}  // namespace planish
