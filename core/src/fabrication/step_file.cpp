// SPDX-License-Identifier: MIT
#include "fabrication/step_file.hpp"

#include "planish/text/number.hpp"
#include "planish/text/utf8.hpp"

namespace planish {
namespace {

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
  while (!utf8.empty()) {
    const std::uint32_t code = take_code_point(utf8);
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
