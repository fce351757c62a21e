// SPDX-License-Identifier: MIT
#include "planish/text/utf8.hpp"

namespace planish {
namespace {

constexpr std::uint32_t kReplacement = 0xFFFD;

/// Which second bytes may follow a first one: others would be too long a form, half of a pair of
/// UTF-16, or beyond U+10FFFF.
bool may_follow(std::uint32_t lead, std::uint32_t second) {
  if (lead == 0xE0) return second >= 0xA0;
  if (lead == 0xED) return second < 0xA0;
  if (lead == 0xF0) return second >= 0x90;
  if (lead == 0xF4) return second < 0x90;
  return true;
}

}  // namespace

std::uint32_t take_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t k) -> std::uint32_t {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
  };
  const std::uint32_t lead = byte(0);
  const bool one_byte = lead < 0x80, is_lead = lead >= 0xC2 && lead <= 0xF4;
  const std::size_t more = !is_lead ? 0 : lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
  std::uint32_t code = one_byte ? lead : lead & (0x3Fu >> more);
  std::size_t taken = 1;
  while (taken <= more && (byte(taken) & 0xC0u) == 0x80u &&
         (taken > 1 || may_follow(lead, byte(1)))) {
    code = code << 6 | (byte(taken++) & 0x3Fu);
  }
  text.remove_prefix(taken);
  return one_byte || (is_lead && taken == more + 1) ? code : kReplacement;
}

std::string as_utf8(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::string_view before = text;
    const std::uint32_t code = take_code_point(text);
    const std::string_view taken = before.substr(0, before.size() - text.size());
    const bool is_written = taken == "\xEF\xBF\xBD";
    result += code == kReplacement && !is_written ? "\xEF\xBF\xBD" : std::string(taken);
  }
  return result;
}

std::string markup_quoted(std::string_view text) {
  std::string quoted;
  for (const char c : as_utf8(text)) {
    if (c == '&') {
      quoted += "&amp;";
    } else if (c == '<') {
      quoted += "&lt;";
    } else {
      quoted += c;
    }
  }
  return quoted;
}

}  // namespace planish
