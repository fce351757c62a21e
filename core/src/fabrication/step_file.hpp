// SPDX-License-Identifier: MIT
/// Entities of a STEP file (ISO 10303-21), one after the other.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>

namespace planish {

/// A value as it stands between the commas of an entity.
struct StepValue {
  std::string text;
};

[[nodiscard]] StepValue step_real(double value);  ///< reads back to the same bits
[[nodiscard]] StepValue step_string(std::string_view utf8);
[[nodiscard]] StepValue step_reference(int entity);        ///< "#12"
[[nodiscard]] StepValue step_word(std::string_view word);  ///< "$", "*", ".T.", "IFCLABEL('x')"

/// "(a,b,c)"
template <typename Range>
[[nodiscard]] StepValue step_list(const Range& values) {
  std::string text = "(";
  for (const StepValue& value : values) text.append(text.size() > 1 ? "," : "").append(value.text);
  return {text + ")"};
}

/// Numbers entities from 1 as they are added.
class StepFile {
 public:
  /// @return its number
  template <typename... Values>
  int add(std::string_view type, const Values&... values) {
    text_.append("#").append(std::to_string(++count_)).append("=").append(type).append("(");
    std::string_view comma;
    ((text_.append(comma).append(values.text), comma = ","), ...);
    text_.append(");\n");
    return count_;
  }
  /// The file; `schema` as "IFC4". It carries no time, so that the same entities give the same
  /// bytes.
  [[nodiscard]] std::string finish(std::string_view schema, std::string_view name) const;

 private:
  std::string text_;
  int count_ = 0;
};

}  // namespace planish
