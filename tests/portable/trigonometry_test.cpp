// SPDX-License-Identifier: MIT
#include "../../core/src/numeric/trigonometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace planish {
namespace {

/// Error of `value` in units of the last place of the exact result.
double ulps(double value, double exact) {
  const double size = std::max(std::abs(exact), std::numeric_limits<double>::min());
  const double ulp = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  return std::abs(value - exact) / ulp;
}

TEST(Trigonometry, AgreesWithTheLibraryToOneUlp) {
  std::mt19937_64 random(7);
  for (const double range : {0.5, 4.0, 40.0, 1e4, 1e5}) {
    std::uniform_real_distribution<double> angle(-range, range);
    for (int k = 0; k < 20000; ++k) {
      const double x = angle(random);
      EXPECT_LE(ulps(sine(x), std::sin(x)), 1.0) << "at " << x;
      EXPECT_LE(ulps(cosine(x), std::cos(x)), 1.0) << "at " << x;
    }
  }
}

TEST(Trigonometry, IsAccurateNextToItsZeros) {
  for (int k = 1; k < 60000; k += 7) {
    const double x = static_cast<double>(k) * (kPi / 2);
    EXPECT_LE(ulps(sine(x), std::sin(x)), 1.0) << "at " << x;
    EXPECT_LE(ulps(cosine(x), std::cos(x)), 1.0) << "at " << x;
  }
}

TEST(Trigonometry, ArctangentAgreesWithTheLibraryInEveryQuadrant) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int k = 0; k < 100000; ++k) {
    const double y = number(random) * std::pow(10.0, 3.0 * number(random));
    const double x = number(random) * std::pow(10.0, 3.0 * number(random));
    EXPECT_LE(std::abs(arctangent(y, x) - std::atan2(y, x)), 1e-15) << y << " " << x;
  }
  for (double small = 1e-300; small < 1.0; small *= 17.0) {
    EXPECT_LE(ulps(arctangent(small, 1.0), std::atan2(small, 1.0)), 2.0) << small;
  }
  EXPECT_EQ(arctangent(0.0, 0.0), 0.0);
  EXPECT_EQ(arctangent(0.0, -1.0), kPi);
  EXPECT_EQ(arctangent(2.0, 0.0), kPi / 2);
  EXPECT_EQ(arctangent(-1.0, 1.0), -kPi / 4);
}

TEST(Trigonometry, IsOddAndEvenToTheBit) {
  for (double x = 0.01; x < 30.0; x += 0.37) {
    EXPECT_EQ(sine(-x), -sine(x));
    EXPECT_EQ(cosine(-x), cosine(x));
  }
  EXPECT_EQ(sine(0.0), 0.0);
  EXPECT_EQ(cosine(0.0), 1.0);
}

}  // namespace
}  // namespace planish
