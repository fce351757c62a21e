// SPDX-License-Identifier: MIT
#include "planish/text/number.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace planish {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A decimal number in parts: ± digits · 10^exponent. `digits` is exact while `exact` holds.
struct Decimal {
  std::uint64_t digits = 0;
  long long exponent = 0;
  bool negative = false, exact = true;
};

/// Takes digits at `at`, counting those after a decimal point into the exponent.
bool take_digits(std::string_view text, std::size_t& at, bool fraction, Decimal& decimal) {
  const std::size_t start = at;
  for (; at < text.size() && is_digit(text[at]); ++at) {
    if (decimal.digits < 1'000'000'000'000'000'000u) {
      decimal.digits = decimal.digits * 10 + static_cast<std::uint64_t>(text[at] - '0');
      if (fraction) --decimal.exponent;
    } else {
      decimal.exact = decimal.exact && text[at] == '0';
      if (!fraction) ++decimal.exponent;
    }
  }
  return at > start;
}

/// Splits `text`; nullopt if it is not a decimal number from first to last character.
std::optional<Decimal> split(std::string_view text) {
  Decimal decimal;
  std::size_t at = 0;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) {
    decimal.negative = text[at++] == '-';
  }
  bool any = take_digits(text, at, false, decimal);
  if (at < text.size() && text[at] == '.') {
    ++at;
    any = take_digits(text, at, true, decimal) || any;
  }
  if (!any) return std::nullopt;
  if (at == text.size()) return decimal;
  if (text[at] != 'e' && text[at] != 'E') return std::nullopt;
  const std::optional<long long> power = parse_integer(text.substr(at + 1));
  if (!power) return std::nullopt;
  decimal.exponent += *power;
  return decimal;
}

/// Clinger's fast path: digits and power are both doubles, so one operation rounds correctly.
std::optional<double> exact_product(const Decimal& decimal) {
  static constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::uint64_t kExactIntegers = std::uint64_t{1} << 53;
  if (!decimal.exact || decimal.digits > kExactIntegers) return std::nullopt;
  if (decimal.exponent < -22 || decimal.exponent > 22) return std::nullopt;
  const auto digits = static_cast<double>(decimal.digits);
  const double power = kPowers[static_cast<std::size_t>(std::abs(decimal.exponent))];
  const double size = decimal.exponent < 0 ? digits / power : digits * power;
  return decimal.negative ? -size : size;
}

#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L

std::optional<double> parse_slowly(std::string_view text, const Decimal& decimal) {
  if (text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc::result_out_of_range) return value;
  // from_chars leaves the value alone here; strtod's convention is 0 or infinity.
  const double limit = decimal.exponent < 0 ? 0.0 : std::numeric_limits<double>::infinity();
  return decimal.negative ? -limit : limit;
}

#else

/// musl's strtod rounds correctly and knows no locales; emscripten's libc++ has no from_chars.
std::optional<double> parse_slowly(std::string_view text, const Decimal&) {
  return std::strtod(std::string(text).c_str(), nullptr);
}

#endif

bool equals_ignoring_case(std::string_view text, std::string_view lower) {
  if (text.size() != lower.size()) return false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k] >= 'A' && text[k] <= 'Z' ? static_cast<char>(text[k] + 32) : text[k];
    if (c != lower[k]) return false;
  }
  return true;
}

std::optional<double> parse_special(std::string_view text) {
  const bool negative = text.front() == '-';
  if (negative || text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  if (equals_ignoring_case(text, "nan")) {
    value = std::numeric_limits<double>::quiet_NaN();
  } else if (equals_ignoring_case(text, "inf") || equals_ignoring_case(text, "infinity")) {
    value = std::numeric_limits<double>::infinity();
  } else {
    return std::nullopt;
  }
  return negative ? -value : value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.empty()) return std::nullopt;
  const std::optional<Decimal> decimal = split(text);
  if (!decimal) return parse_special(text);
  if (const std::optional<double> value = exact_product(*decimal)) return value;
  return parse_slowly(text, *decimal);
}

std::optional<long long> parse_integer(std::string_view text) {
  constexpr long long kLimit = 1LL << 62;
  std::size_t at = 0;
  bool negative = false;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) negative = text[at++] == '-';
  if (at == text.size()) return std::nullopt;
  long long value = 0;
  for (; at < text.size(); ++at) {
    if (!is_digit(text[at]) || value > kLimit / 10 - 1) return std::nullopt;
    value = value * 10 + (text[at] - '0');
  }
  return negative ? -value : value;
}

void append_number(std::string& text, double value, int digits) {
  std::array<char, 64> buffer;
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                    std::chars_format::general, digits);
  text.append(buffer.data(), result.ptr);
#else
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  text.append(buffer.data(), static_cast<std::size_t>(length));
#endif
}

std::string three_digits(double value) {
  std::string text;
  append_number(text, value, 3);
  return text;
}

void append_exact(std::string& text, double value) {
  const std::size_t start = text.size();
  for (int digits = 15; digits <= 17; ++digits) {
    text.resize(start);
    append_number(text, value, digits);
    const std::optional<double> read = parse_number(std::string_view(text).substr(start));
    if (digits == 17 || (read && *read == value)) return;
  }
}

void append_integer(std::string& text, long long value) {
  std::array<char, 24> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), result.ptr);
}

}  // namespace planish
