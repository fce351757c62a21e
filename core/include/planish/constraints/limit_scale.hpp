// SPDX-License-Identifier: MIT
/// How a bounded value becomes a share: 1/2 or more where no force acts, 0 at the bound. [LIM-2]
#pragma once

#include <algorithm>

namespace planish {

/// s = slope · g + offset for a value g that has a bound.
///
/// The bound is relative: where the base exceeds what was asked for, it lies a little (`allowance`)
/// beyond the base's own value, so the base keeps it. And the share is at least 1/2 at the base,
/// where the barrier begins [SHP-3]: a panel at rest feels no force.
struct LimitScale {
  double slope = 0.0;
  double offset = 1.0;
  bool exceeded = false;  ///< by the base

  [[nodiscard]] double share(double value) const { return slope * value + offset; }

  /// g ≤ asked. @param width > 0, of g between the bound and where s = 1; @param allowance > 0
  [[nodiscard]] static LimitScale at_most(double asked, double base, double width,
                                          double allowance) {
    const double bound = std::max(asked, base + allowance);
    const double range = std::min(width, 2.0 * (bound - base));
    return {-1.0 / range, bound / range, base > asked};
  }

  /// g ≥ asked. The same for the other side.
  [[nodiscard]] static LimitScale at_least(double asked, double base, double width,
                                           double allowance) {
    const double bound = std::min(asked, base - allowance);
    const double range = std::min(width, 2.0 * (base - bound));
    return {1.0 / range, -bound / range, base < asked};
  }
};

}  // namespace planish
