// SPDX-License-Identifier: MIT
/// What a solve took, as counts that no machine changes.
#pragma once

namespace planish {

struct SolveCost {
  int steps = 0;  ///< of Newton's method, or of alternating minimisation
  int factorizations = 0;

  SolveCost& operator+=(const SolveCost& other) {
    steps += other.steps;
    factorizations += other.factorizations;
    return *this;
  }
  friend SolveCost operator+(SolveCost a, const SolveCost& b) { return a += b; }
  friend bool operator==(const SolveCost&, const SolveCost&) = default;
};

}  // namespace planish
