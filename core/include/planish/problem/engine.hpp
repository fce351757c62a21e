// SPDX-License-Identifier: MIT
/// The choice that all three problems share, and what it leaves out.
#pragma once

#include "planish/text/refusal.hpp"

namespace planish {

/// Which solver runs. Both read the same problem.
enum class Engine {
  kNewton,               ///< second order on a working set: interactive, exact [WSN-1]
  kAugmentedLagrangian,  ///< the paper's: the reference [ALM-1]
};

/// What may be asked for beyond the paper's problems, which know panels and other equations,
/// weights, handles and pins.
enum class Beyond {
  kSupports,
  kKeepOuts,
  kSymmetry,
  kContinuation,
  kFewest,
  kSplits,
  kMobility,
  kBends,
};

/// The one rule of what an engine solves: Newton's method everything, the paper's none of `beyond`.
/// @returns why not, with the name of `beyond` in designs; nullopt where it does
[[nodiscard]] Refusal find_problem(Engine engine, Beyond beyond);

}  // namespace planish
