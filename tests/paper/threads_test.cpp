// SPDX-License-Identifier: MIT
/// The paper's parallel steps (Sec. 3.5) on threads: the same bits for any number of them.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "planish/edit/handle_edit.hpp"
#include "planish/projection/projection.hpp"
#include "planish/variations/subspace.hpp"
#include "support/scenes.hpp"
#include "thread_pool.hpp"

namespace planish {
namespace {

using workflow::ThreadPool;

/// Threads, and what was asked of them.
class WatchedPool final : public Executor {
 public:
  explicit WatchedPool(int threads) : pool_(threads) {}
  void run(int count, const std::function<void(int)>& task) override {
    tasks_ += count;
    pool_.run(count, task);
  }
  [[nodiscard]] int tasks() const { return tasks_; }

 private:
  ThreadPool pool_;
  int tasks_ = 0;
};

/// On one thread without an executor, and on pools of several numbers of threads.
template <class Solve>
void expect_same_bits(const Solve& solve) {
  const auto alone = solve(nullptr);
  for (const int threads : {1, 2, 3, 5}) {
    if ((threads == 1 || threads == 3) && !testing::is_night()) continue;
    SCOPED_TRACE(threads);
    const auto pool = std::make_shared<WatchedPool>(threads);
    const auto together = solve(pool);
    EXPECT_GT(pool->tasks(), 0) << "too small a problem to be divided";
    EXPECT_EQ(alone, together);
  }
}

/// What depends on every residual that a stop was decided by.
std::vector<double> trace_of(const SolveReport& report) {
  std::vector<double> trace{static_cast<double>(report.cost.steps)};
  for (const IterationRecord& record : report.records) {
    trace.insert(trace.end(), {record.objective, record.primal_residual, record.dual_residual});
  }
  return trace;
}

std::vector<double> with(std::vector<double> trace, const Eigen::MatrixXd& values) {
  trace.insert(trace.end(), values.data(), values.data() + values.size());
  return trace;
}

TEST(OnThreads, AnEditHasTheSameBits) {
  for (const char* name : {"vault", "hex"}) {
    SCOPED_TRACE(name);
    const Mesh mesh = testing::sample(name, 32);
    const EditTargets targets = testing::pull(mesh, testing::middle_vertex(mesh), {0, 0, 0.5});
    expect_same_bits([&](std::shared_ptr<Executor> executor) {
      const HandleEditResult result =
          solve_handle_edit(mesh, targets,
                            {.engine = Engine::kAugmentedLagrangian,
                             .executor = std::move(executor),
                             .max_iterations = testing::by_night(40, 15)});
      return with(trace_of(result.report), result.moved_positions);
    });
  }
}

TEST(OnThreads, AProjectionHasTheSameBits) {
  Mesh bent = testing::sample("dome", 32);
  bent.positions += 0.02 * testing::random_points(3, bent.vertex_count());
  expect_same_bits([&](std::shared_ptr<Executor> executor) {
    const ProjectionResult result =
        project_to_planar(bent, {.fairness_weight = 1.0,
                                 .engine = Engine::kAugmentedLagrangian,
                                 .executor = std::move(executor),
                                 .keep_shape = false,
                                 .max_iterations = testing::by_night(40, 15)});
    return with(trace_of(result.report), result.moved_positions);
  });
}

/// Conical rows beside the panels: blocks of another kind.
TEST(OnThreads, RowsOfAnotherKindHaveTheSameBits) {
  Mesh bent = testing::sample("vault", 24);
  bent.positions += 0.005 * testing::random_points(3, bent.vertex_count());
  expect_same_bits([&](std::shared_ptr<Executor> executor) {
    const ProjectionResult result = project_to_planar(bent, {.engine = Engine::kAugmentedLagrangian,
                                                             .executor = std::move(executor),
                                                             .keep_shape = false,
                                                             .constraints = {{"conical", 1e-6}},
                                                             .max_iterations = 10});
    return with(trace_of(result.report), result.moved_positions);
  });
}

TEST(OnThreads, ASubspaceHasTheSameBits) {
  const Mesh mesh = testing::sample("dome", 24);
  const int handle = testing::middle_vertex(mesh);
  const Positions edited =
      apply(mesh, solve_handle_edit(mesh, testing::pull(mesh, handle, {0, 0, 0.5})));
  expect_same_bits([&](const std::shared_ptr<Executor>& executor) {
    const Subspace subspace =
        compute_subspace(mesh, edited, {handle},
                         {.dimension = 2, .reach = 8, .engine = Engine::kAugmentedLagrangian}, {},
                         {}, executor.get());
    return with({static_cast<double>(subspace.report.iterations)}, subspace.basis);
  });
}

class PoolOf : public ::testing::TestWithParam<int> {};

TEST_P(PoolOf, ThreadsDoesEachTaskOnce) {
  ThreadPool pool(GetParam());
  for (int round = 0; round < 2000; ++round) {
    std::vector<int> done(static_cast<std::size_t>(round % 17), 0);
    pool.run(round % 17, [&](int k) { ++done[static_cast<std::size_t>(k)]; });
    for (const int times : done) ASSERT_EQ(times, 1) << round;
  }
}

/// A pool of an edit that two threads of a program explore, and tasks that ask for more.
TEST_P(PoolOf, ThreadsServesSeveralAndNested) {
  ThreadPool pool(GetParam());
  std::atomic<int> sum = 0;
  const auto add = [&] {
    for (int round = 0; round < 200; ++round) {
      pool.run(3, [&](int) { pool.run(2, [&](int k) { sum += k + 1; }); });
    }
  };
  std::thread other(add);
  add();
  other.join();
  EXPECT_EQ(sum, 2 * 200 * 3 * 3);
}

INSTANTIATE_TEST_SUITE_P(Threads, PoolOf, ::testing::Values(1, 2, 3, 5));

}  // namespace
}  // namespace planish
