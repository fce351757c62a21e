// SPDX-License-Identifier: MIT
/// What a session says of a solve that gave nothing to show.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "planish/problem/solve_report.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

[[nodiscard]] inline Refusal unusable(const SolveReport& report, std::string_view what) {
  if (report.usable()) return std::nullopt;
  std::string reason(status_name(report.status));
  std::replace(reason.begin(), reason.end(), '_', ' ');
  return std::string(what) + " did not reach a flat result (" + reason +
         "); the design is as it was.";
}

}  // namespace planish
