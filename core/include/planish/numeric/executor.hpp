// SPDX-License-Identifier: MIT
/// Independent tasks on threads of the caller's: the core starts none.
#pragma once

#include <algorithm>
#include <functional>

namespace planish {

/// Runs tasks side by side. A null one: one after the other on the thread of the caller.
class Executor {
 public:
  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// Calls task(k) once for each 0 ≤ k < count, in any order, on any thread; returns after the
  /// last one. Tasks share nothing that one of them writes, and do not throw.
  virtual void run(int count, const std::function<void(int)>& task) = 0;
};

/// Calls visit(begin, end) for parts of [0, count) that together are the whole. What `visit` writes
/// for one index depends on no other, so that bits depend neither on parts nor on threads.
/// @param part > 0: indices that are worth a task
template <class Visit>
void for_each_part(Executor* executor, int count, int part, const Visit& visit) {
  if (executor == nullptr || count <= part) {
    visit(0, count);
    return;
  }
  executor->run((count + part - 1) / part,
                [&](int k) { visit(k * part, std::min((k + 1) * part, count)); });
}

}  // namespace planish
