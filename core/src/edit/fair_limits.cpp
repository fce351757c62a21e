// SPDX-License-Identifier: MIT
#include "planish/edit/fair_limits.hpp"

#include <algorithm>
#include <utility>

#include "planish/constraints/fold_limit.hpp"
#include "planish/edit/fewest.hpp"

namespace planish {
namespace {

/// Degrees by which a fold at a limit may seem to exceed it.
constexpr double kRounding = 0.01;
/// Share of the way to the targets that handles may lose by a limit.
constexpr double kLoss = 0.05;

class FairLimits {
 public:
  FairLimits(const EditStanding& free, double way, const LimitedEdit& edit)
      : standing_(free), way_(way), edit_(edit) {}

  void limit_folds() {
    const EditStanding free = standing_;
    for (const double degrees : kFairFolds) {
      if (degrees >= free.fold_growth) continue;
      const auto limited = attempt({std::string(FoldLimit::kName), 0.0, degrees, true});
      if (limited && costs_nothing(free, *limited)) return keep(*limited);
    }
    go_back();
  }

  void limit_corners() {
    const EditStanding free = standing_;
    if (free.slivers == 0) return;
    const auto limited = attempt(*parse_stated_limit(kBuildableCorners));
    const double fair = std::max(free.fold_growth, kFairFolds.front()) + kRounding;
    if (limited && limited->slivers == 0 && limited->fold_growth <= fair &&
        costs_nothing(free, *limited)) {
      return keep(*limited);
    }
    go_back();
  }

  [[nodiscard]] std::vector<StatedLimit> take() { return std::move(found_); }

 private:
  /// Whether handles get about as far with a limit as in `free`, the edit without it.
  [[nodiscard]] bool costs_nothing(const EditStanding& free, const EditStanding& limited) const {
    return limited.moved_vertices > 0 && limited.status != SolveStatus::kInfeasibleHandles &&
           limited.handle_error <= free.handle_error + kLoss * way_;
  }

  std::optional<EditStanding> attempt(StatedLimit limit) {
    std::vector<StatedLimit> limits = found_;
    limits.push_back(std::move(limit));
    tried_ = limits;
    return edit_(limits);
  }

  void keep(const EditStanding& limited) {
    standing_ = limited;
    found_ = *std::exchange(tried_, std::nullopt);
  }

  /// Makes the edit without what was tried and found wanting.
  void go_back() {
    if (!std::exchange(tried_, std::nullopt)) return;
    if (const auto again = edit_(found_)) standing_ = *again;
  }

  EditStanding standing_;  ///< of the edit with what was found
  double way_;
  const LimitedEdit& edit_;
  std::vector<StatedLimit> found_;
  std::optional<std::vector<StatedLimit>> tried_;  ///< by the edit made last, where not `found_`
};

}  // namespace

std::vector<StatedLimit> find_fair_limits(const EditStanding& free, const FairSearch& search,
                                          const LimitedEdit& edit) {
  FairLimits limits(free, search.way, edit);
  if (search.folds) limits.limit_folds();
  if (search.corners) limits.limit_corners();
  return limits.take();
}

}  // namespace planish
