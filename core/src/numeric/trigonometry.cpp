// SPDX-License-Identifier: MIT
#include "numeric/trigonometry.hpp"

#include <cmath>

namespace planish {
namespace {

/// angle = quadrant · π/2 + high + low with |high| ≤ π/4; `low` is what rounding took from `high`.
struct ReducedAngle {
  int quadrant;
  double high, low;
};

/// Cody and Waite: π/2 in three parts of 33 bits, so that each product with a quadrant below 2²⁰
/// is exact.
ReducedAngle reduce(double angle) {
  constexpr double kTwoOverPi = 6.36619772367581382433e-01;
  constexpr double kFirst = 1.57079632673412561417e+00;
  constexpr double kSecond = 6.07710050630396597660e-11;
  constexpr double kThird = 2.02226624871116645580e-21;
  constexpr double kRest = 8.47842766036889956997e-32;
  const double quadrant = std::floor(angle * kTwoOverPi + 0.5);
  const double first = angle - quadrant * kFirst;
  const double second_part = quadrant * kSecond;
  const double second = first - second_part;
  const double second_error = (first - second) - second_part;
  const double third_part = quadrant * kThird;
  const double third = second - third_part;
  const double third_error = (second - third) - third_part;
  const double tail = second_error + third_error - quadrant * kRest;
  const double high = third + tail;
  return {static_cast<int>(quadrant) & 3, high, (third - high) + tail};
}

/// Minimax polynomial of fdlibm for |x| ≤ π/4; x + tail is the angle.
double sine_kernel(double x, double tail) {
  constexpr double kS1 = -1.66666666666666324348e-01, kS2 = 8.33333333332248946124e-03,
                   kS3 = -1.98412698298579493134e-04, kS4 = 2.75573137070700676789e-06,
                   kS5 = -2.50507602534068634195e-08, kS6 = 1.58969099521155010221e-10;
  const double z = x * x;
  const double cube = z * x;
  const double r = kS2 + z * (kS3 + z * (kS4 + z * (kS5 + z * kS6)));
  return x - ((z * (0.5 * tail - cube * r) - tail) - cube * kS1);
}

double cosine_kernel(double x, double tail) {
  constexpr double kC1 = 4.16666666666666019037e-02, kC2 = -1.38888888888741095749e-03,
                   kC3 = 2.48015872894767294178e-05, kC4 = -2.75573143513906633035e-07,
                   kC5 = 2.08757232129817482790e-09, kC6 = -1.13596475577881948265e-11;
  const double z = x * x;
  const double r = z * (kC1 + z * (kC2 + z * (kC3 + z * (kC4 + z * (kC5 + z * kC6)))));
  const double half = 0.5 * z;
  const double one_minus_half = 1.0 - half;
  return one_minus_half + (((1.0 - one_minus_half) - half) + (z * r - x * tail));
}

/// sin(angle + shift · π/2).
double shifted_sine(double angle, int shift) {
  const ReducedAngle reduced = reduce(angle);
  const int quadrant = (reduced.quadrant + shift) & 3;
  const bool odd = (quadrant & 1) != 0;
  const double value =
      odd ? cosine_kernel(reduced.high, reduced.low) : sine_kernel(reduced.high, reduced.low);
  return quadrant >= 2 ? -value : value;
}

/// atan(t) for 0 ≤ t ≤ 7/16, minimax polynomial of fdlibm.
double arctangent_kernel(double t) {
  constexpr double kEven[] = {3.33333333333329318027e-01, 1.42857142725034663711e-01,
                              9.09088713343650656196e-02, 6.66107313738753120669e-02,
                              4.97687799461593236017e-02, 1.62858201153657823623e-02};
  constexpr double kOdd[] = {-1.99999999998764832476e-01, -1.11111104054623557880e-01,
                             -7.69187620504482999495e-02, -5.83357013379057348645e-02,
                             -3.65315727442169155270e-02};
  const double z = t * t;
  const double w = z * z;
  double even = kEven[5];
  for (int k = 4; k >= 0; --k) even = kEven[k] + w * even;
  double odd = kOdd[4];
  for (int k = 3; k >= 0; --k) odd = kOdd[k] + w * odd;
  return t - t * (z * even + w * odd);
}

/// atan(t) for 0 ≤ t ≤ 1: the kernel about 0, or about atan(1/2) or atan(1).
double arctangent_below_one(double t) {
  constexpr double kHalf = 4.63647609000806093515e-01, kHalfRest = 2.26987774529616870924e-17;
  constexpr double kOne = 7.85398163397448278999e-01, kOneRest = 3.06161699786838301793e-17;
  const auto signed_kernel = [](double u) {
    return u < 0.0 ? -arctangent_kernel(-u) : arctangent_kernel(u);
  };
  if (t < 0.4375) return arctangent_kernel(t);
  if (t < 0.6875) return kHalf + (signed_kernel((2.0 * t - 1.0) / (2.0 + t)) + kHalfRest);
  return kOne + (signed_kernel((t - 1.0) / (t + 1.0)) + kOneRest);
}

}  // namespace

double sine(double angle) { return shifted_sine(angle, 0); }

double cosine(double angle) { return shifted_sine(angle, 1); }

double arctangent(double y, double x) {
  const double height = std::abs(y);
  const double width = std::abs(x);
  if (height == 0.0 && width == 0.0) return 0.0;
  const bool steep = height > width;
  double angle = arctangent_below_one(steep ? width / height : height / width);
  if (steep) angle = 0.5 * kPi - angle;
  if (x < 0.0) angle = kPi - angle;
  return y < 0.0 ? -angle : angle;
}

}  // namespace planish
