// SPDX-License-Identifier: MIT
#include "progress.hpp"

namespace planish::python {

namespace py = pybind11;

Progress Watch::progress() {
  return [this](const IterationRecord& record) { return step(record); };
}

Flow Watch::step(const IterationRecord& record) {
  if (stopped_) return Flow::kStop;
  const py::gil_scoped_acquire lock;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!callable_.is_none()) {
      const py::object answer = callable_(++steps_, record.objective, record.primal_residual);
      stopped_ = answer.ptr() == Py_False;
    }
  } catch (...) {  // no exception passes through a solver
    raised_ = std::current_exception();
    stopped_ = true;
  }
  return stopped_ ? Flow::kStop : Flow::kContinue;
}

void Watch::rethrow() const {
  if (raised_) std::rethrow_exception(raised_);
}

}  // namespace planish::python
