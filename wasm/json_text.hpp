// SPDX-License-Identifier: MIT
/// Reports as JSON text. The page parses them with JSON.parse; a whole JSON library would weigh a
/// tenth of the module.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planish {

/// Writes one JSON object, field by field. Numbers that are not finite become null.
class JsonText {
 public:
  JsonText& add(std::string_view key, double value);
  JsonText& add(std::string_view key, int value) { return add(key, static_cast<double>(value)); }
  JsonText& add(std::string_view key, std::size_t value) {
    return add(key, static_cast<double>(value));
  }
  JsonText& add(std::string_view key, bool value);
  JsonText& add(std::string_view key, std::string_view value);
  JsonText& add(std::string_view key, const std::vector<double>& values);
  JsonText& add(std::string_view key, const std::vector<int>& values);
  JsonText& add(std::string_view key, const std::vector<std::string>& values);
  JsonText& add(std::string_view key, const JsonText& object);
  /// Without this a text literal would be taken for a bool.
  JsonText& add(std::string_view key, const char* value) {
    return add(key, std::string_view(value));
  }

  /// The object so far, closed.
  [[nodiscard]] std::string text() const { return body_.empty() ? "{}" : "{" + body_ + "}"; }

 private:
  void begin(std::string_view key);

  std::string body_;
};

}  // namespace planish
