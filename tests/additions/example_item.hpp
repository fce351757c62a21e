// SPDX-License-Identifier: MIT
/// The item of the list option that additions.json adds: a number.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planish/text/number.hpp"
#include "planish/text/refusal.hpp"
#include "planish/text/text_item.hpp"

namespace planish {

struct ExampleItem {
  double number = 0.0;

  friend bool operator==(const ExampleItem&, const ExampleItem&) = default;
};

[[nodiscard]] inline Refusal find_problem(const std::vector<ExampleItem>& items) {
  for (const ExampleItem& item : items) {
    if (!(item.number > 0.0)) return "example_item must be greater than 0";
  }
  return std::nullopt;
}

template <>
struct TextItem<ExampleItem> {
  static constexpr std::size_t kMost = 4, kLongest = 40;
  static std::optional<ExampleItem> parse(std::string_view text) {
    const auto number = parse_number(text);
    return number ? std::optional(ExampleItem{*number}) : std::nullopt;
  }
  static std::string text(const ExampleItem& item) {
    std::string text;
    append_exact(text, item.number);
    return text;
  }
  static std::string known() { return "NUMBER"; }
  static ExampleItem unread(std::string_view) { return {-1.0}; }
};

}  // namespace planish
