// SPDX-License-Identifier: MIT
/// The limit on areas: how large a panel may be. g = ½ ‖Σ pₖ × pₖ₊₁‖. [LIM-6]
#pragma once

#include <string_view>
#include <vector>

#include "planish/constraints/limit_kind.hpp"

namespace planish {

struct AreaRow {
  static constexpr int kArity = Eigen::Dynamic;
  std::vector<int> vertices;  ///< of the panel, in order
  LimitScale scale;
};

using PanelPoints = RowPoints<Eigen::Dynamic>;

[[nodiscard]] double value(const AreaRow& row, const PanelPoints& points);
[[nodiscard]] PanelPoints gradient(const AreaRow& row, const PanelPoints& points);
[[nodiscard]] LimitHessian<Eigen::Dynamic> hessian(const AreaRow& row, const PanelPoints& points);

/// area=MAX, squared model units.
struct AreaLimit {
  static constexpr std::string_view kName = "area";
  static constexpr std::string_view kForm = "MAX";
  using Row = AreaRow;
  static void append_rows(const LimitBase& base, int face, const StatedLimit& limit,
                          std::vector<Row>& out);
};

}  // namespace planish
