// SPDX-License-Identifier: MIT
/// What an inequality of a patch adds to its objective. [SHP-3] [LIM-2]
#pragma once

#include <type_traits>

#include "planish/problem/problem.hpp"

namespace planish {

/// t of a row. A spring that holds what rests is no barrier that fades.
template <class Row>
[[nodiscard]] double barrier_weight(const Patch& patch, const Row& row) {
  if constexpr (std::is_same_v<Row, CornerShape>) return patch.shape_weight;
  if constexpr (std::is_same_v<Row, KeepOutRow>) return row.rests ? 1.0 : patch.limit_weight;
  return patch.limit_weight;
}

/// t B(s) at s = scale(g), and its first two derivatives by g. Infinite beyond the bound.
template <class Row>
[[nodiscard]] Barrier weighted_barrier(const Patch& patch, const Row& row, double g) {
  const double weight = barrier_weight(patch, row), by_value = row.scale.slope;
  const Barrier cost = cost_at(row, row.scale.share(g));
  return {weight * cost.value, weight * cost.slope * by_value,
          weight * cost.curvature * by_value * by_value};
}

}  // namespace planish
