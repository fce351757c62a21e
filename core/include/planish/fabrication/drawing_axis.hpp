// SPDX-License-Identifier: MIT
/// Axes and levels of the building, which drawings of the structure show.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace planish {

/// The plane where one coordinate has one value: an axis where that is x or y, a level where it is
/// z.
struct DrawingAxis {
  int coordinate = 2;  ///< 0: x, 1: y, 2: z
  double at = 0.0;     ///< finite, model units
  std::string name;    ///< may be empty
};

/// What parse_drawing_axis() takes, in words.
inline constexpr std::string_view kDrawingAxisForm = "x=V, y=V or z=V, or one with :NAME behind it";

/// "x=4.5", "y=0:A" or "z=3.2:Eaves"; nullopt for any other text.
[[nodiscard]] std::optional<DrawingAxis> parse_drawing_axis(std::string_view text);

}  // namespace planish
