// SPDX-License-Identifier: MIT
/// Wall-clock time for reports and for the time budget of a drag.
#pragma once

#include <chrono>

namespace planish {

/// Starts when it is made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace planish
