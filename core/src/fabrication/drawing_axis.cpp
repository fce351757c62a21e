// SPDX-License-Identifier: MIT
#include "planish/fabrication/drawing_axis.hpp"

#include <cmath>

#include "planish/text/number.hpp"

namespace planish {

std::optional<DrawingAxis> parse_drawing_axis(std::string_view text) {
  constexpr std::string_view kCoordinates = "xyz";
  if (text.size() < 3 || text[1] != '=') return std::nullopt;
  const std::size_t coordinate = kCoordinates.find(text[0]);
  const std::string_view rest = text.substr(2);
  const std::size_t colon = rest.find(':');
  const auto at = parse_number(rest.substr(0, colon));
  if (coordinate == std::string_view::npos || !at || !std::isfinite(*at)) return std::nullopt;
  const bool named = colon != std::string_view::npos;
  return DrawingAxis{static_cast<int>(coordinate), *at,
                     named ? std::string(rest.substr(colon + 1)) : std::string()};
}

}  // namespace planish
