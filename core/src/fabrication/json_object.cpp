// SPDX-License-Identifier: MIT
#include "fabrication/json_object.hpp"

#include "planish/text/number.hpp"
#include "planish/text/utf8.hpp"

namespace planish {

JsonObject& JsonObject::raw(std::string_view field, std::string_view json) {
  text_.append(text_.empty() ? "{" : ",\n").append(json_quoted(field)).append(":").append(json);
  return *this;
}

JsonObject& JsonObject::add(std::string_view field, std::string_view text) {
  return raw(field, json_quoted(text));
}

JsonObject& JsonObject::add(std::string_view field, double number) {
  std::string digits;
  append_exact(digits, number);
  return raw(field, digits);
}

JsonObject& JsonObject::add(std::string_view field, const std::vector<std::string>& texts) {
  std::string list = "[";
  for (const std::string& text : texts) {
    list.append(list.size() > 1 ? "," : "").append(json_quoted(text));
  }
  return raw(field, list + "]");
}

JsonObject& JsonObject::add(std::string_view field, const std::vector<int>& numbers) {
  std::string list = "[";
  for (const int number : numbers) {
    if (list.size() > 1) list += ',';
    append_integer(list, number);
  }
  return raw(field, list + "]");
}

std::string json_quoted(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : as_utf8(text)) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (code < 0x20) {
      quoted += "\\u00";
      quoted += kHex[code >> 4];
      quoted += kHex[code & 15];
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

}  // namespace planish
