// SPDX-License-Identifier: MIT
/// The limit by a sheet: every panel fits into a rectangle. [LIM-7]
///
/// The rectangle lies along the panel's side that leaves the most room in the base. With v that
/// side and u from one corner to another, g is the squared length of u along v, or across it: both
/// follow the panel wherever it tilts. A panel that only fits some other way round is not tried:
/// what keeps these rows fits, not every panel that fits keeps them. Panels of more than 64 corners
/// are not limited.
#pragma once

#include <string_view>
#include <vector>

#include "planish/constraints/limit_kind.hpp"

namespace planish {

struct SheetRow {
  static constexpr int kArity = Eigen::Dynamic;
  std::vector<int> vertices;  ///< of u and v, at most four
  LimitScale scale;
  Eigen::VectorXd u, v;  ///< the two as sums of the points
  bool along = true;
};

[[nodiscard]] double value(const SheetRow& row, const RowPoints<Eigen::Dynamic>& points);
[[nodiscard]] RowPoints<Eigen::Dynamic> gradient(const SheetRow& row,
                                                 const RowPoints<Eigen::Dynamic>& points);
[[nodiscard]] LimitHessian<Eigen::Dynamic> hessian(const SheetRow& row,
                                                   const RowPoints<Eigen::Dynamic>& points);

/// sheet=WxH, model units.
struct SheetLimit {
  static constexpr std::string_view kName = "sheet";
  static constexpr std::string_view kForm = "WxH";
  using Row = SheetRow;
  /// Two rows for every two corners: the square of the panel's corners.
  static void append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                          std::vector<Row>& out);
};

}  // namespace planish
