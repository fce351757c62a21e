// SPDX-License-Identifier: MIT
/// A JSON object, written field by field.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planish {

class JsonObject {
 public:
  JsonObject& raw(std::string_view field, std::string_view json);
  JsonObject& add(std::string_view field, std::string_view text);
  JsonObject& add(std::string_view field, const char* text) {
    return add(field, std::string_view(text));
  }
  JsonObject& add(std::string_view field, double number);
  JsonObject& add(std::string_view field, const std::vector<std::string>& texts);
  JsonObject& add(std::string_view field, const std::vector<int>& numbers);
  [[nodiscard]] std::string text() const { return text_ + "}"; }

 private:
  std::string text_;
};

/// `text` as a JSON string, with its quotes.
[[nodiscard]] std::string json_quoted(std::string_view text);

}  // namespace planish
