// SPDX-License-Identifier: MIT
#include "fabrication/step_file.hpp"

#include "planish/text/number.hpp"

namespace planish {
namespace {

/// The code point that starts at `at`, which moves past it; what is not UTF-8 reads as U+FFFD.
std::uint32_t next_code_point(std::string_view text, std::size_t& at) {
  constexpr std::uint32_t kReplacement = 0xFFFD;
  const auto byte = [&](std::size_t k) -> std::uint32_t {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
  };
  const std::uint32_t lead = byte(at++);
  if (lead < 0x80) return lead;
  const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
  if (more == 0) return kReplacement;
  std::uint32_t code = lead & (0x3Fu >> static_cast<unsigned>(more));
  for (int k = 0; k < more; ++k) {
    if ((byte(at) & 0xC0u) != 0x80u) return kReplacement;
    code = code << 6 | (byte(at++) & 0x3Fu);
  }
  return code;
}

void append_hexadecimal(std::string& text, std::uint32_t value, int digits) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
    text += kDigits[value >> static_cast<unsigned>(shift) & 15u];
  }
}

}  // namespace

/// STEP wants a point in every real number, and a capital E.
StepValue step_real(double value) {
  std::string text;
  append_exact(text, value);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos) text[exponent] = 'E';
  if (text.find('.') == std::string::npos) {
    text.insert(exponent == std::string::npos ? text.size() : exponent, 1, '.');
  }
  return {text};
}

StepValue step_string(std::string_view utf8) {
  std::string text = "'";
  for (std::size_t at = 0; at < utf8.size();) {
    const std::uint32_t code = next_code_point(utf8, at);
    if (code == '\'' || code == '\\') {
      text.append(2, static_cast<char>(code));
    } else if (code >= 0x20 && code < 0x7F) {
      text += static_cast<char>(code);
    } else {
      const bool wide = code > 0xFFFF;
      text += wide ? "\\X4\\" : "\\X2\\";
      append_hexadecimal(text, code, wide ? 8 : 4);
      text += "\\X0\\";
    }
  }
  return {text + "'"};
}

StepValue step_reference(int entity) {
  std::string text = "#";
  return {text.append(std::to_string(entity))};
}

StepValue step_word(std::string_view word) { return {std::string(word)}; }

std::string StepFile::finish(std::string_view schema, std::string_view name) const {
  std::string file = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('ViewDefinition [";
  file += "ReferenceView_V1.2]'),'2;1');\nFILE_NAME(" + step_string(name).text;
  file += ",'1970-01-01T00:00:00',(''),(''),'Planish','Planish','');\nFILE_SCHEMA(('";
  file.append(schema).append("'));\nENDSEC;\nDATA;\n").append(text_);
  return file + "ENDSEC;\nEND-ISO-10303-21;\n";
}

}  // namespace planish
