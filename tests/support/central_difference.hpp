// SPDX-License-Identifier: MIT
/// Derivatives by differences, to hold written ones against.
#pragma once

#include <Eigen/Core>
#include <type_traits>

namespace planish::testing {

/// (f(x + h e_k) − f(x − h e_k)) / 2h. @param k coordinate of `points` in the order of their memory
template <class Points, class Function>
[[nodiscard]] auto central_difference(const Points& points, Eigen::Index k, double step,
                                      const Function& f) {
  Points ahead = points;
  Points behind = points;
  ahead.data()[k] += step;
  behind.data()[k] -= step;
  using Result = std::decay_t<decltype(f(points))>;
  return Result((f(ahead) - f(behind)) / (2.0 * step));
}

}  // namespace planish::testing
