// SPDX-License-Identifier: MIT
/// What the keep-outs of a patch add to its objective and its gradient. [KEE-2] [LIM-2]
#pragma once

#include <Eigen/Core>

#include "planish/problem/problem.hpp"

namespace planish {

/// @returns `energy` and theirs: infinite beyond a plane. @param displacement 3 × free
[[nodiscard]] double with_keep_outs(double energy, const Patch& patch,
                                    const Eigen::Matrix3Xd& displacement);

void add_keep_out_gradient(const Patch& patch, const Eigen::Matrix3Xd& displacement,
                           Eigen::Matrix3Xd& out);

}  // namespace planish
