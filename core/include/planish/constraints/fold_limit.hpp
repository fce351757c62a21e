// SPDX-License-Identifier: MIT
/// The limit on folds: how sharply two neighbouring panels may meet. [LIM-3]
///
/// With e the common edge and a, b a further point of either panel, the panels' normals are
/// e × a and b × e, and g = cos ∠ of the two: exact where both panels are flat.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "planish/constraints/limit_kind.hpp"

namespace planish {

struct FoldRow {
  static constexpr int kArity = 4;
  std::array<int, 4> vertices{};  ///< the edge's ends, a point of this panel, one of the other
  LimitScale scale;
  double side = 1.0;  ///< −1 where the points give one of the normals the wrong way round
  std::array<int, 2> panels{};  ///< this and the other
};

[[nodiscard]] double value(const FoldRow& row, const RowPoints<4>& points);
[[nodiscard]] RowPoints<4> gradient(const FoldRow& row, const RowPoints<4>& points);
[[nodiscard]] LimitHessian<4> hessian(const FoldRow& row, const RowPoints<4>& points);

/// fold=MAX or fold=+MAX, degrees between the normals.
struct FoldLimit {
  static constexpr std::string_view kName = "fold";
  static constexpr std::string_view kForm = "MAX or +MAX";
  using Row = FoldRow;
  /// Appends one row for each edge that `face` shares with exactly one other face of a higher
  /// number.
  static void append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                          std::vector<Row>& out);
};

}  // namespace planish
