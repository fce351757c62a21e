// SPDX-License-Identifier: MIT
/// All that a patch keeps from one side: panels' shapes, stated limits and keep-outs, as one batch.
/// Every row has g, a smooth function of a few vertices, and a scale that makes it a share: 1/2 or
/// more where no force acts, 0 at the bound. [LIM-2]
#pragma once

#include <algorithm>

#include "planish/constraints/corner_shape.hpp"
#include "planish/constraints/keep_out_row.hpp"
#include "planish/constraints/limit_kinds.hpp"

namespace planish {

/// No corner loses its side. [SHP-1]
struct ShapeBound {
  using Row = CornerShape;
};

/// A point stays on the free side of a plane. [KEE-1]
struct KeepOutPlane {
  using Row = KeepOutRow;
};

using InequalityKinds = LimitKinds::With<KeepOutPlane>::After<ShapeBound>;
using InequalityRows = RowBatches<InequalityKinds>;

/// How hard a row is kept, as a function of its share.
template <class Row>
[[nodiscard]] Barrier cost_at(const Row& /*row*/, double share) {
  return clamped_barrier(share);
}

/// A point that rests has no room for a barrier: a spring pushes it back where it goes deeper.
/// [KEE-2]
[[nodiscard]] inline Barrier cost_at(const KeepOutRow& row, double share) {
  constexpr double kStiffness = 1e5;
  if (!row.rests) return clamped_barrier(share);
  const double force = kStiffness * std::min(share, 0.0);
  return {0.5 * force * std::min(share, 0.0), force, share < 0.0 ? kStiffness : 0.0};
}

}  // namespace planish
