// SPDX-License-Identifier: MIT
/// The choice that all three problems share.
#pragma once

namespace planish {

/// Which solver runs. Both read the same problem.
enum class Engine {
  kNewton,               ///< second order on a working set: interactive, exact [WSN-1]
  kAugmentedLagrangian,  ///< the paper's: the reference [ALM-1]
};

}  // namespace planish
