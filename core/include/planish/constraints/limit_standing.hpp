// SPDX-License-Identifier: MIT
/// How near panels, or points to keep-outs, are to one limit. [LIM-2]
#pragma once

#include <limits>
#include <string_view>
#include <vector>

namespace planish {

struct LimitStanding {
  std::string_view name;  ///< of the limit, as reports say it
  double least_share = std::numeric_limits<double>::infinity();  ///< ≥ 0: it holds
  std::vector<int> binding;  ///< panels that it holds back, or points, ascending
};

}  // namespace planish
