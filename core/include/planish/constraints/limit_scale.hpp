// SPDX-License-Identifier: MIT
/// How a bounded value becomes a share: 0 at the bound, 1 a width within it. [LIM-2]
#pragma once

#include <algorithm>

namespace planish {

/// s = slope · g + offset for a value g that has a bound.
///
/// The bound is relative: where the base exceeds what was asked for, it lies a little (`allowance`)
/// beyond the base's own value, so the base keeps it.
struct LimitScale {
  double slope = 0.0;
  double offset = 1.0;
  bool exceeded = false;  ///< by the base

  [[nodiscard]] double share(double value) const { return slope * value + offset; }

  /// g ≤ asked. @param width > 0, of g between the bound and where s = 1; @param allowance > 0
  [[nodiscard]] static LimitScale at_most(double asked, double base, double width,
                                          double allowance) {
    const double bound = std::max(asked, base + allowance);
    return {-1.0 / width, bound / width, base > asked};
  }

  /// g ≥ asked. The same for the other side.
  [[nodiscard]] static LimitScale at_least(double asked, double base, double width,
                                           double allowance) {
    const double bound = std::min(asked, base - allowance);
    return {1.0 / width, -bound / width, base < asked};
  }
};

}  // namespace planish
