// SPDX-License-Identifier: MIT
#include "planish/text/number.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>
#include <random>
#include <string>

namespace planish {
namespace {

/// The same bits as the C library reads.
void expect_read_as_strtod(const std::string& text) {
  const std::optional<double> read = parse_number(text);
  ASSERT_TRUE(read) << text;
  const double wanted = std::strtod(text.c_str(), nullptr);
  EXPECT_EQ(*read, wanted) << text;
  EXPECT_EQ(std::signbit(*read), std::signbit(wanted)) << text;
}

TEST(Number, AnyDoubleIsReadBackFromSeventeenDigitsAndFromTheShortest) {
  std::mt19937_64 random(11);
  for (int k = 0; k < 20000; ++k) {
    double value = 0.0;
    const std::uint64_t bits = random();
    static_assert(sizeof value == sizeof bits);
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    std::array<char, 40> digits{};
    std::snprintf(digits.data(), digits.size(), "%.17g", value);
    expect_read_as_strtod(digits.data());
    std::string shortest;
    append_exact(shortest, value);
    EXPECT_EQ(parse_number(shortest), value) << shortest;
  }
}

TEST(Number, DecimalsOfAnyLengthAreRoundedAsTheCLibraryRoundsThem) {
  std::mt19937 random(12);
  const auto below = [&](unsigned limit) { return static_cast<int>(random() % limit); };
  for (int k = 0; k < 20000; ++k) {
    std::string text = below(2) == 0 ? "-" : "";
    const int length = 1 + below(25);
    const int point = below(50);  // behind that digit; often behind none
    for (int d = 0; d < length; ++d) {
      text += static_cast<char>('0' + below(10));
      if (d == point) text += '.';
    }
    if (below(2) == 0) {
      text += 'e';
      text += std::to_string(below(700) - 350);
    }
    expect_read_as_strtod(text);
  }
}

TEST(Number, HardCasesAreRoundedAsTheCLibraryRoundsThem) {
  for (const char* text : {"9007199254740993",
                           "9007199254740992.5",
                           "1e23",
                           "8.5e22",
                           "2.2250738585072011e-308",
                           "2.2250738585072014e-308",
                           "4.9406564584124654e-324",
                           "2.4703282292062327e-324",
                           "2.4703282292062328e-324",
                           "1.7976931348623157e308",
                           "1.7976931348623159e308",
                           "1e400",
                           "-1e400",
                           "1e-400",
                           "-0",
                           "0e999",
                           "1.",
                           ".5",
                           "+.5e1",
                           "00012",
                           "0.500000000000000166533453693773481063544750213623046875"}) {
    expect_read_as_strtod(text);
  }
}

TEST(Number, WhatIsNoNumberFromFirstToLastCharacterIsNone) {
  for (const char* text : {"", "+", "-", ".", "e5", "1e", "1e+", "1 ", " 1", "1,5", "0x10", "1.2.3",
                           "+-1", "nan(1)", "infinit", "1f"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
  EXPECT_TRUE(std::isnan(*parse_number("NaN")));
  EXPECT_EQ(parse_number("-Infinity"), -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace planish
