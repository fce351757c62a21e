// SPDX-License-Identifier: MIT
#include "lengths.hpp"

#include <optional>

#include "planish/fabrication/cutting_plan.hpp"
#include "planish/text/number.hpp"

namespace planish::workflow {
namespace {

constexpr std::string_view kKnown = "mm, cm, m, km, in, ft";
constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";

/// A number and the word behind it, spaces between the two or not.
struct Measured {
  std::string_view number, unit;
};

Measured measured(std::string_view text) {
  const std::size_t end = text.find_last_not_of(kLetters) + 1;
  const std::string_view number = text.substr(0, end);
  return {number.substr(0, number.find_last_not_of(' ') + 1), text.substr(end)};
}

/// From one unit to another. Divides by how many make one where they are smaller: 700 mm are 0.7 m.
struct Conversion {
  double from = 1.0, to = 1.0;  ///< metres

  [[nodiscard]] double operator()(double value) const {
    return from < to ? value / (to / from) : value * (from / to);
  }
};

/// nullopt where one of them is no unit.
std::optional<Conversion> conversion(std::string_view unit, const std::string& other) {
  const auto from = metres_in(std::string(unit)), to = metres_in(other);
  if (!from || !to) return std::nullopt;
  return Conversion{*from, *to};
}

/// `text` with its parts as `plain` has them.
template <class Plain>
std::string with_parts(std::string_view text, const Plain& plain) {
  constexpr std::string_view kBetween = "=:,x";
  std::string result;
  while (true) {
    const std::size_t end = text.find_first_of(kBetween);
    result += plain(text.substr(0, end));
    if (end == std::string_view::npos) return result;
    result += text[end];
    text.remove_prefix(end + 1);
  }
}

/// `part` itself unless it is a number with a unit behind it.
/// @param power of the unit: 2 for an area
std::string plain_part(std::string_view part, const Measured& parts, const std::string& unit,
                       int power) {
  const auto value = parse_number(parts.number);
  const auto convert = conversion(parts.unit, unit);
  if (!value || !convert) return std::string(part);
  double converted = *value;
  for (int k = 0; k < power; ++k) converted = (*convert)(converted);
  std::string text;
  append_exact(text, converted);
  return text;
}

}  // namespace

std::string model_unit(const Request& request) {
  std::string unit = request.value("--model-unit").value_or("m");
  if (metres_in(unit)) return unit;
  throw UsageError("--model-unit: \"" + unit + "\" is none of " + std::string(kKnown));
}

double parse_share(std::string_view text, std::string_view what) {
  if (text.ends_with('%')) return 0.01 * parse_finite(text.substr(0, text.size() - 1), what);
  throw UsageError(std::string(what) + ": \"" + std::string(text) + "\" is not P%");
}

double parse_length(const Json& value, std::string_view what, const std::string& unit) {
  const std::string text = text_of(value);
  const Measured parts = measured(text);
  if (value.is_number() || parts.unit.empty() || !parse_number(parts.number)) {
    return parse_finite(value, what);
  }
  if (const auto convert = conversion(parts.unit, unit)) {
    return (*convert)(parse_finite(std::string(parts.number), what));
  }
  throw UsageError(std::string(what) + ": \"" + std::string(parts.unit) + "\" is none of " +
                   std::string(kKnown));
}

double parse_length(const Json& value, std::string_view what, const std::string& unit,
                    double whole) {
  const std::string text = text_of(value);
  return text.ends_with('%') ? parse_share(text, what) * whole : parse_length(value, what, unit);
}

void read_length(const Request& request, std::string_view option, const std::string& unit,
                 double& length) {
  if (const Json* value = request.last(option)) length = parse_length(*value, option, unit);
}

std::string plain_lengths(std::string_view text, const std::string& unit) {
  return with_parts(
      text, [&](std::string_view part) { return plain_part(part, measured(part), unit, 1); });
}

std::string plain_areas(std::string_view text, const std::string& unit) {
  return with_parts(text, [&](std::string_view part) {
    if (!part.ends_with('2')) return std::string(part);
    return plain_part(part, measured(part.substr(0, part.size() - 1)), unit, 2);
  });
}

}  // namespace planish::workflow
