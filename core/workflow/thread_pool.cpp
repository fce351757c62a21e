// SPDX-License-Identifier: MIT
#include "thread_pool.hpp"

#include <string>
#include <system_error>

namespace planish::workflow {
namespace {

constexpr std::uint64_t kRun = std::uint64_t{1} << 32;
constexpr std::uint64_t kTasks = kRun - 1;

/// Returns once `word` is no longer `old`: tasks follow each other within a millisecond, and to
/// wake a thread that sleeps takes a part of that.
template <class Value>
void wait_for_another(const std::atomic<Value>& word, Value old) {
  constexpr int kLooks = 20'000;  // 10 ms
  for (int k = 0; k < kLooks; ++k) {
    if (word.load(std::memory_order_acquire) != old) return;
    std::this_thread::yield();
  }
  word.wait(old, std::memory_order_acquire);
}

}  // namespace

ThreadPool::ThreadPool(int threads) {
  for (int k = 1; k < threads; ++k) threads_.emplace_back([this] { work(); });
}

ThreadPool::~ThreadPool() {
  ends_ = true;
  state_ += kRun;
  state_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(int count, const std::function<void(int)>& task) {
  if (count <= 0) return;
  if (threads_.empty() || count == 1 || busy_.test_and_set(std::memory_order_acquire)) {
    for (int k = 0; k < count; ++k) task(k);
    return;
  }
  task_.store(&task, std::memory_order_relaxed);
  unfinished_.store(count, std::memory_order_relaxed);
  std::uint64_t seen = (state_.load() / kRun + 1) * kRun + static_cast<std::uint64_t>(count);
  state_.store(seen, std::memory_order_release);
  state_.notify_all();
  while ((seen & kTasks) != 0) static_cast<void>(take_one(seen));
  for (int left = unfinished_.load(); left != 0; left = unfinished_.load()) {
    wait_for_another(unfinished_, left);
  }
  busy_.clear(std::memory_order_release);
}

bool ThreadPool::take_one(std::uint64_t& seen) {
  if (!state_.compare_exchange_weak(seen, seen - 1, std::memory_order_acq_rel)) return false;
  (*task_.load(std::memory_order_relaxed))(static_cast<int>(--seen & kTasks));
  if (unfinished_.fetch_sub(1, std::memory_order_acq_rel) == 1) unfinished_.notify_one();
  seen = state_.load(std::memory_order_acquire);
  return true;
}

void ThreadPool::work() {
  std::uint64_t seen = 0;
  while (!ends_) {
    if ((seen & kTasks) != 0) {
      static_cast<void>(take_one(seen));
    } else {
      wait_for_another(state_, seen);
      seen = state_.load(std::memory_order_acquire);
    }
  }
}

std::optional<int> stated_threads(const Request& request) {
  const Json* stated = request.last("--threads");
  if (stated == nullptr) return std::nullopt;
  const int count = parse_whole(*stated, "--threads");
  if (count < 1 || count > kMostThreads) {
    throw UsageError("--threads must be from 1 to " + std::to_string(kMostThreads));
  }
  return count;
}

std::shared_ptr<Executor> stated_executor(const Request& request, Engine engine) {
  const std::optional<int> threads = stated_threads(request);
  if (!threads) return nullptr;
  if (engine == Engine::kNewton) throw UsageError("--threads: newton has one; alm takes more");
  if (*threads == 1) return nullptr;
  try {
    return std::make_shared<ThreadPool>(*threads);
  } catch (const std::system_error&) {
    throw UsageError("--threads: there are no " + std::to_string(*threads) + " here");
  }
}

}  // namespace planish::workflow
