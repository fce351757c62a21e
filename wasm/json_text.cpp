// SPDX-License-Identifier: MIT
#include "json_text.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace planish {
namespace {

void append(std::string& text, double value) {
  std::array<char, 32> digits{};
  if (!std::isfinite(value)) {
    text += "null";
    return;
  }
  std::snprintf(digits.data(), digits.size(), "%.17g", value);
  text += digits.data();
}

void append(std::string& text, std::string_view value) {
  text += '"';
  for (const char c : value) {
    std::array<char, 8> escaped{};
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (static_cast<unsigned char>(c) < ' ') {
      std::snprintf(escaped.data(), escaped.size(), "\\u%04x", static_cast<unsigned>(c));
      text += escaped.data();
    } else {
      text += c;
    }
  }
  text += '"';
}

template <class Values>
void append_list(std::string& text, const Values& values) {
  text += '[';
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0) text += ',';
    append(text, values[k]);
  }
  text += ']';
}

}  // namespace

void JsonText::begin(std::string_view key) {
  if (!body_.empty()) body_ += ',';
  append(body_, key);
  body_ += ':';
}

JsonText& JsonText::add(std::string_view key, double value) {
  begin(key);
  append(body_, value);
  return *this;
}

JsonText& JsonText::add(std::string_view key, bool value) {
  begin(key);
  body_ += value ? "true" : "false";
  return *this;
}

JsonText& JsonText::add(std::string_view key, std::string_view value) {
  begin(key);
  append(body_, value);
  return *this;
}

JsonText& JsonText::add(std::string_view key, const std::vector<double>& values) {
  begin(key);
  append_list(body_, values);
  return *this;
}

JsonText& JsonText::add(std::string_view key, const std::vector<int>& values) {
  return add(key, std::vector<double>(values.begin(), values.end()));
}

JsonText& JsonText::add(std::string_view key, const std::vector<std::string>& values) {
  begin(key);
  append_list(body_, values);
  return *this;
}

JsonText& JsonText::add(std::string_view key, const JsonText& object) {
  begin(key);
  body_ += object.text();
  return *this;
}

}  // namespace planish
