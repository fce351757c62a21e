// SPDX-License-Identifier: MIT
/// Numbers as text, exactly and whatever the process's locale is.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace planish {

/// The double nearest to `text`, which must be a decimal number from first to last character:
/// leading +, exponents, "nan" and "inf" allowed (so that a caller can say what is wrong with
/// them); too large gives ±inf. nullopt if it is not a number.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// A whole number with optional sign, from first to last character; nullopt also past ±2⁶².
[[nodiscard]] std::optional<long long> parse_integer(std::string_view text);

/// Appends `value` with `digits` significant digits, as printf's %.*g.
void append_number(std::string& text, double value, int digits);

/// `value` for reading, not for storing: three significant digits.
[[nodiscard]] std::string three_digits(double value);

/// Appends finite `value` so that parse_number() gives the same bits: the shortest of 15, 16 or 17
/// digits that does.
void append_exact(std::string& text, double value);

/// Appends a whole number.
void append_integer(std::string& text, long long value);

}  // namespace planish
