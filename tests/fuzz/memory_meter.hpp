// SPDX-License-Identifier: MIT
/// How much memory a piece of code held at once, measured through the sanitizer's hooks.
#pragma once

#include <cstddef>

namespace planish::fuzz {

/// Measures from construction on. One at a time.
class MemoryMeter {
 public:
  MemoryMeter();
  ~MemoryMeter();
  MemoryMeter(const MemoryMeter&) = delete;
  MemoryMeter& operator=(const MemoryMeter&) = delete;

  /// The most bytes held at once since construction, beyond what was held before.
  [[nodiscard]] std::size_t peak() const;
};

}  // namespace planish::fuzz
