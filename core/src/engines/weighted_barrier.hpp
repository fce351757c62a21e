// SPDX-License-Identifier: MIT
/// What an inequality without a multiplier adds to a patch's objective. [SHP-3] [KEE-1]
#pragma once

#include "planish/problem/problem.hpp"

namespace planish {

[[nodiscard]] inline double barrier_weight(const Patch& patch, const CornerShape& /*corner*/) {
  return patch.shape_weight;
}

/// A spring that holds what rests is no barrier that fades.
[[nodiscard]] inline double barrier_weight(const Patch& patch, const KeepOutRow& row) {
  return row.rests ? 1.0 : patch.keep_out_weight;
}

/// t B(s) at s = scale(g), and its first two derivatives by g; nothing for a row with a multiplier.
/// Infinite beyond a bound.
template <class Row>
[[nodiscard]] Barrier weighted_barrier([[maybe_unused]] const Patch& patch,
                                       [[maybe_unused]] const Row& row, [[maybe_unused]] double g) {
  if constexpr (!kHasMultiplier<Row>) {
    const double weight = barrier_weight(patch, row);
    const double by_value = row.scale.slope;
    const Barrier cost = cost_at(row, row.scale.share(g));
    return {weight * cost.value, weight * cost.slope * by_value,
            weight * cost.curvature * by_value * by_value};
  }
  return {};
}

}  // namespace planish
