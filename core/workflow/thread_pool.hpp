// SPDX-License-Identifier: MIT
/// The threads behind --threads: the core has none of its own.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "planish/numeric/executor.hpp"
#include "planish/problem/engine.hpp"
#include "request.hpp"

namespace planish::workflow {

/// Threads that wait for tasks, for a moment awake and then asleep. A second run() while one is on
/// has its own thread alone.
class ThreadPool final : public Executor {
 public:
  /// @param threads ≥ 1, the caller's among them
  explicit ThreadPool(int threads);
  ~ThreadPool() override;
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  void run(int count, const std::function<void(int)>& task) override;

 private:
  void work();
  /// Takes one task of those that are left. @param seen state_ as it was; renewed if none was taken
  bool take_one(std::uint64_t& seen);

  /// Number of the run in the upper half, tasks that nobody has taken in the lower: one word, so
  /// that who slept through a run cannot take a task of the next by the number of an old one.
  std::atomic<std::uint64_t> state_ = 0;
  std::atomic<const std::function<void(int)>*> task_ = nullptr;
  std::atomic<int> unfinished_ = 0;
  std::atomic<bool> ends_ = false;
  std::atomic_flag busy_;
  std::vector<std::thread> threads_;
};

inline constexpr OptionRow kThreadsRow = {"--threads", "N",
                                          "of the solver alm, default 1; the result is the same"};

/// Threads at most: more would wait for each other.
inline constexpr int kMostThreads = 256;

/// What --threads asks for; nullopt without. Throws UsageError.
[[nodiscard]] std::optional<int> stated_threads(const Request& request);

/// The threads that --threads asks for as an executor of `engine`'s parallel steps; null for one.
/// Throws UsageError where `engine` has none, or where the system has no more threads.
[[nodiscard]] std::shared_ptr<Executor> stated_executor(const Request& request, Engine engine);

}  // namespace planish::workflow
