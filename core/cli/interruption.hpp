// SPDX-License-Identifier: MIT
/// Ctrl-C as a wish to stop with what has been found.
#pragma once

#include <csignal>

namespace planish::cli {

/// While one lives, the first SIGINT ends nothing: it is remembered. The next one ends the command.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  [[nodiscard]] static bool is_asked_for();

 private:
  struct sigaction before_ = {};
};

}  // namespace planish::cli
