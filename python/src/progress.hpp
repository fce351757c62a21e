// SPDX-License-Identifier: MIT
/// A solver's progress as a Python callable, which may stop it.
#pragma once

#include <pybind11/pybind11.h>

#include <exception>

#include "planish/problem/solve_report.hpp"

namespace planish::python {

/// Calls back after every step of a solver that runs without the interpreter's lock. A callable
/// that returns False, one that raises, and Ctrl-C stop the solve.
class Watch {
 public:
  /// @param callable (step, objective, residual) -> bool | None, or None
  explicit Watch(pybind11::object callable) : callable_(std::move(callable)) {}

  /// Refers to this object.
  [[nodiscard]] Progress progress();

  /// Raises what the callable raised; to be called with the lock, after the solve.
  void rethrow() const;

 private:
  Flow step(const IterationRecord& record);

  pybind11::object callable_;
  int steps_ = 0;
  bool stopped_ = false;
  std::exception_ptr raised_;
};

/// `solve(progress)` without the interpreter's lock.
template <class Solve>
auto run_unlocked(pybind11::object callable, const Solve& solve) {
  Watch watch(std::move(callable));
  auto result = [&] {
    const pybind11::gil_scoped_release unlocked;
    return solve(watch.progress());
  }();
  watch.rethrow();
  return result;
}

}  // namespace planish::python
