// SPDX-License-Identifier: MIT
/// Limits that an edit gets unasked, where they cost its handles nothing: on folds, where it folds
/// panels sharply though it need not, and on corners, where it makes slivers though it need not.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "planish/constraints/stated_limit.hpp"
#include "planish/edit/edit_standing.hpp"

namespace planish {

/// Degrees by which folds may sharpen: a limit is tried at each, the first that takes nothing
/// stands. Multiples of ten, as the page knows those that it found.
inline constexpr std::array kFairFolds = {10.0, 20.0};

/// What limits are looked for.
struct FairSearch {
  double way = 0.0;  ///< of the handle that goes furthest, from the base to its target; model units
  bool folds = true;
  bool corners = true;
};

/// Makes the edit with these limits beside its own; nullopt where there is no such edit.
using LimitedEdit =
    std::function<std::optional<EditStanding>(const std::vector<StatedLimit>& limits)>;

/// The limit on folds with which the handles get as far as in `free`, the edit without it, then
/// that on corners, kBuildableCorners, which must leave no sliver and fold no more sharply than is
/// fair or than without it. None that is not needed is tried; the edit made last, where one was, is
/// that with the limits that are returned.
[[nodiscard]] std::vector<StatedLimit> find_fair_limits(const EditStanding& free,
                                                        const FairSearch& search,
                                                        const LimitedEdit& edit);

}  // namespace planish
