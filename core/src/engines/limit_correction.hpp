// SPDX-License-Identifier: MIT
/// Back within the limits that a state breaks by a little: what a frame of a drag leaves, whose
/// steps are few. [LIM-2]
#pragma once

#include <Eigen/Core>

#include "planish/problem/problem.hpp"

namespace planish {

/// Whether a state does. @param displacement 3 × free
[[nodiscard]] bool breaks_limits(const Patch& patch, const Eigen::Matrix3Xd& displacement);

/// The nearest states at which the linearised equations hold and no limit that was broken on the
/// way is; some passes, until none is broken.
/// @param displacement 3 × free, in and out; the equations hold only nearly afterwards
void correct_limits(const Patch& patch, Eigen::Matrix3Xd& displacement, int& factorizations);

}  // namespace planish
