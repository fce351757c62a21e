// SPDX-License-Identifier: MIT
#include "../../core/src/numeric/logarithm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish {
namespace {

TEST(NaturalLogarithm, IsWithinAFewUnitsInTheLastPlace) {
  for (int k = -300; k <= 300; ++k) {
    const double x = std::pow(1.37, k);
    EXPECT_NEAR(natural_logarithm(x), std::log(x), 4e-16 * std::max(1.0, std::abs(std::log(x))));
  }
}

}  // namespace
}  // namespace planish
