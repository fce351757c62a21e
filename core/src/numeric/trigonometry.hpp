// SPDX-License-Identifier: MIT
/// Sine, cosine and arctangent with the same bits on every platform: libm's differ between glibc
/// and musl, and a shared link must rebuild its sample exactly.
#pragma once

namespace planish {

/// π to double precision.
inline constexpr double kPi = 3.14159265358979323846;

/// Sine of `angle` in radians, |angle| ≤ 1e5; error below 1 ulp of the result's size.
[[nodiscard]] double sine(double angle);

/// Cosine of `angle` in radians, |angle| ≤ 1e5; error below 1 ulp of the result's size.
[[nodiscard]] double cosine(double angle);

/// The angle of the point (x, y) about the origin, radians, −π … π, as atan2(y, x); 0 at the
/// origin. Error below 2 ulp of π.
[[nodiscard]] double arctangent(double y, double x);

}  // namespace planish
