// SPDX-License-Identifier: MIT
#include "numeric/logarithm.hpp"

#include <cmath>

namespace planish {

double natural_logarithm(double x) {
  constexpr double kLogOfTwo = 0.693147180559945309417;
  constexpr double kRootOfHalf = 0.707106781186547524401;
  constexpr int kTerms = 12;
  int exponent = 0;
  double fraction = std::frexp(x, &exponent);  // exact on every platform
  if (fraction < kRootOfHalf) {
    fraction *= 2.0;
    --exponent;
  }
  // ln f = 2 artanh z with z = (f − 1)/(f + 1), |z| < 0.172: twelve terms reach rounding.
  const double z = (fraction - 1.0) / (fraction + 1.0);
  const double square = z * z;
  double sum = 0.0;
  for (int k = kTerms; k-- > 0;) sum = 1.0 / (2.0 * k + 1.0) + square * sum;
  return 2.0 * z * sum + exponent * kLogOfTwo;
}

}  // namespace planish
