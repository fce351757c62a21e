// SPDX-License-Identifier: MIT
/// All that a patch keeps from one side: panels' shapes, stated limits and keep-outs, as one batch.
/// Every row has g, a smooth function of a few vertices, and a scale that makes it a share, which
/// is 0 at the bound. [LIM-2]
#pragma once

#include <algorithm>
#include <type_traits>

#include "planish/constraints/corner_shape.hpp"
#include "planish/constraints/keep_out_row.hpp"
#include "planish/constraints/limit_kinds.hpp"
#include "planish/constraints/straight_corner.hpp"

namespace planish {

/// No corner loses its side. [SHP-1]
struct ShapeBound {
  using Row = CornerShape;
};

/// No straight corner turns inwards. [SHP-4]
struct StraightBound {
  using Row = StraightCorner;
};

/// A point stays on the free side of a plane. [KEE-1]
struct KeepOutPlane {
  using Row = KeepOutRow;
};

using InequalityKinds = LimitKinds::With<KeepOutPlane>::With<StraightBound>::After<ShapeBound>;
using InequalityRows = RowBatches<InequalityKinds>;

/// Whether a row is a constraint with a multiplier of its own. The others are part of the
/// objective: a panel without its shape is degenerate, so a barrier keeps clear of it [SHP-3], and
/// planes of keep-outs turn and let go, so what presses on one says little about the next [KEE-1].
template <class Row>
inline constexpr bool kHasMultiplier =
    !std::is_same_v<Row, CornerShape> && !std::is_same_v<Row, KeepOutRow>;
template <class Row>
[[nodiscard]] constexpr bool has_multiplier(const Row& /*row*/) {
  return kHasMultiplier<Row>;
}

/// Share by which solvers stay within the bound of a row with a multiplier: more than what they
/// leave of it, and far less than what anybody builds to.
inline constexpr double kLimitMargin = 1e-6;

/// What a row without a multiplier costs, by its share.
[[nodiscard]] inline Barrier cost_at(const CornerShape& /*corner*/, double share) {
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
