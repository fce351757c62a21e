// SPDX-License-Identifier: MIT
#include "interruption.hpp"

namespace planish::cli {
namespace {

/// All that a handler of signals may touch.
volatile std::sig_atomic_t& asked_for() {
  static volatile std::sig_atomic_t asked = 0;
  return asked;
}

void remember(int) { asked_for() = 1; }

}  // namespace

Interruption::Interruption() {
  asked_for() = 0;
  struct sigaction action = {};
  action.sa_handler = remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, &before_);
}

Interruption::~Interruption() { sigaction(SIGINT, &before_, nullptr); }

bool Interruption::is_asked_for() { return asked_for() != 0; }

}  // namespace planish::cli
