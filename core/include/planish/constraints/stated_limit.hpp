// SPDX-License-Identifier: MIT
/// Limits that someone states for an edit: folds, angles, lengths, sizes, slides. [LIM-1]
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planish/text/refusal.hpp"
#include "planish/text/text_item.hpp"

namespace planish {

/// One limit. It is relative to the base: what exceeds it there may not get worse, and blocks
/// nothing else.
struct StatedLimit {
  std::string name;       ///< of constraints/limit_kinds.hpp, for example "fold"
  double least = 0.0;     ///< of a range; the shorter side of a sheet; 0 where a limit has none
  double most = 0.0;      ///< > 0; degrees, model units or their square
  bool relative = false;  ///< `most` is what may be added to the base's own value

  friend bool operator==(const StatedLimit&, const StatedLimit&) = default;
};

/// The first rule that `limits` break, naming the limit; nullopt if none.
[[nodiscard]] Refusal find_problem(const std::vector<StatedLimit>& limits);

[[nodiscard]] bool has_limit(const std::vector<StatedLimit>& limits, std::string_view name);

/// Adds each of `usual` of whose name there is none.
void add_unstated(std::vector<StatedLimit>& limits, const std::vector<StatedLimit>& usual);

/// "fold=MAX", "fold=+MAX", "angle=MIN:MAX", "edge=MIN:MAX", "area=MAX", "sheet=WxH" or
/// "slide=MAX".
/// @returns nullopt where the text is none of these; the numbers' rules are find_problem()'s
[[nodiscard]] std::optional<StatedLimit> parse_stated_limit(std::string_view text);

/// The text that parse_stated_limit() reads, with the same bits.
[[nodiscard]] std::string stated_limit_text(const StatedLimit& limit);

/// What the value of a limit must be, "MIN:MAX" for example; nullopt where there is no such limit.
[[nodiscard]] std::optional<std::string> limit_form(std::string_view name);

/// The names and forms of all limits, for messages.
[[nodiscard]] std::string known_limits();

template <>
struct TextItem<StatedLimit> {
  static constexpr std::size_t kMost = 16, kLongest = 400;
  static std::optional<StatedLimit> parse(std::string_view text) {
    return parse_stated_limit(text);
  }
  static std::string text(const StatedLimit& limit) { return stated_limit_text(limit); }
  static std::string known() { return known_limits(); }
  static StatedLimit unread(std::string_view text) { return {.name = std::string(text)}; }
};

}  // namespace planish
