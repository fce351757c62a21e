// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "session.hpp"

namespace planish {

std::vector<KeepOut> read_keep_outs(std::string_view lines) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<KeepOut> keep_outs;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const KeepOut none{KeepOut::Kind::kBelow, {kNone}};
    keep_outs.push_back(parse_keep_out(lines.substr(0, end)).value_or(none));
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return keep_outs;
}

}  // namespace planish
