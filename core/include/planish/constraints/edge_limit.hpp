// SPDX-License-Identifier: MIT
/// The limit on edges: how short or long one may be. g = ‖e‖². [LIM-5]
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "planish/constraints/limit_kind.hpp"

namespace planish {

struct EdgeRow {
  static constexpr int kArity = 2;
  std::array<int, 2> vertices{};
  LimitScale scale;
  std::array<int, 2> panels{};  ///< this and the other, −1 where there is none
};

[[nodiscard]] double value(const EdgeRow& row, const RowPoints<2>& points);
[[nodiscard]] RowPoints<2> gradient(const EdgeRow& row, const RowPoints<2>& points);
[[nodiscard]] LimitHessian<2> hessian(const EdgeRow& row, const RowPoints<2>& points);

/// edge=MIN:MAX, model units; a MIN of 0 is none.
struct EdgeLimit {
  static constexpr std::string_view kName = "edge";
  static constexpr std::string_view kForm = "MIN:MAX";
  using Row = EdgeRow;
  /// The sides of `face`, of those that it shares with one other where its number is the lower.
  static void append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                          std::vector<Row>& out);
};

}  // namespace planish
