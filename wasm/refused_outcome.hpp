// SPDX-License-Identifier: MIT
/// What a session says of a solve that gave nothing to show, and of what the core refuses.
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

/// A clause as a sentence of the page, not as a clause of the command line.
[[nodiscard]] inline std::string as_sentence(std::string clause) {
  const bool is_word = clause.size() > 1 && clause[1] >= 'a' && clause[1] <= 'z';
  if (is_word && clause[0] >= 'a' && clause[0] <= 'z') clause[0] += 'A' - 'a';
  return clause.back() == '.' ? clause : clause + ".";
}

}  // namespace planish
