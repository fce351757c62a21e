// SPDX-License-Identifier: MIT
/// The limit on angles: how far a panel's corners may close or open. g = cos θ. [LIM-4]
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "planish/constraints/limit_kind.hpp"

namespace planish {

struct AngleRow {
  static constexpr int kArity = 3;
  std::array<int, 3> vertices{};  ///< previous, this, next
  LimitScale scale;
};

[[nodiscard]] double value(const AngleRow& row, const RowPoints<3>& points);
[[nodiscard]] RowPoints<3> gradient(const AngleRow& row, const RowPoints<3>& points);
[[nodiscard]] LimitHessian<3> hessian(const AngleRow& row, const RowPoints<3>& points);

/// angle=MIN:MAX, degrees inside the panel, 0 … 180. Of a reflex corner the angle outside counts:
/// it has nothing to do with the limits, and the shape bound keeps its side.
struct AngleLimit {
  static constexpr std::string_view kName = "angle";
  static constexpr std::string_view kForm = "MIN:MAX";
  using Row = AngleRow;
  static void append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                          std::vector<Row>& out);
};

}  // namespace planish
