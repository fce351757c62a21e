// SPDX-License-Identifier: MIT
#include "engines/sparse_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <tuple>

#include "support/scenes.hpp"

namespace planish {
namespace {

constexpr double kSolveError = 1e-10;

RaggedRows rows_of(const std::vector<std::set<int>>& near) {
  RaggedRows rows;
  for (const auto& list : near) {
    rows.values.insert(rows.values.end(), list.begin(), list.end());
    rows.offsets.push_back(static_cast<int>(rows.values.size()));
  }
  return rows;
}

/// Grid edges, some random ones, a hub that sees everything, and nodes without neighbours.
RaggedRows random_graph(unsigned seed, int nodes) {
  std::mt19937 engine(seed);
  std::vector<std::set<int>> near(static_cast<std::size_t>(nodes));
  const auto join = [&](int a, int b) {
    if (a == b || a % 11 == 7 || b % 11 == 7) return;  // every eleventh node stays alone
    near[static_cast<std::size_t>(a)].insert(b);
    near[static_cast<std::size_t>(b)].insert(a);
  };
  const auto pick = [&] { return static_cast<int>(engine() % static_cast<unsigned>(nodes)); };
  for (int k = 0; k + 1 < nodes; ++k) join(k, k + 1);
  for (int k = 0; k + 5 < nodes; ++k) join(k, k + 5);
  for (int k = 0; k < nodes / 2; ++k) join(pick(), pick());
  if (seed % 3 == 0) {
    for (int k = 1; k < nodes; ++k) join(0, k);
  }
  return rows_of(near);
}

/// Random symmetric blocks on the graph, made diagonally dominant.
Eigen::MatrixXd random_matrix(unsigned seed, const RaggedRows& graph, int block) {
  const int n = graph.size() * block;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  std::mt19937 engine(seed);
  const auto value = [&] { return static_cast<double>(engine()) / 2147483648.0 - 1.0; };
  for (int i = 0; i < graph.size(); ++i) {
    for (const int j : graph[i]) {
      if (j > i) continue;
      for (int r = 0; r < block; ++r)
        for (int c = 0; c < block; ++c) dense(i * block + r, j * block + c) = value();
    }
    for (int r = 0; r < block; ++r)
      for (int c = 0; c < r; ++c) dense(i * block + r, i * block + c) = value();
  }
  dense = (dense + dense.transpose()).eval();
  dense.diagonal() = dense.cwiseAbs().rowwise().sum().array() + 0.5;
  return dense;
}

void fill(SparseCholesky& cholesky, const RaggedRows& graph, const Eigen::MatrixXd& dense) {
  const int block = cholesky.block_size();
  cholesky.set_zero();
  const auto put = [&](int row, int column) {
    const BlockSlot slot = cholesky.slot(row, column);
    for (int r = 0; r < block; ++r)
      for (int c = 0; c < block; ++c)
        cholesky.values()[static_cast<std::size_t>(slot.offset + r + c * slot.stride)] +=
            dense(row * block + r, column * block + c);
  };
  for (int i = 0; i < graph.size(); ++i) {
    put(i, i);
    for (const int j : graph[i]) {
      if (cholesky.position(i) > cholesky.position(j)) put(i, j);
    }
  }
}

using Case = std::tuple<unsigned, int, int, EliminationOrder>;

class SparseCholeskyOn : public ::testing::TestWithParam<Case> {};

TEST_P(SparseCholeskyOn, SolvesLikeADenseFactor) {
  const auto [seed, nodes, block, order] = GetParam();
  const RaggedRows graph = random_graph(seed, nodes);
  SparseCholesky cholesky;
  cholesky.analyze(graph, block, order);
  for (unsigned again = 0; again < 2; ++again) {  // one analysis serves several factorizations
    const Eigen::MatrixXd dense = random_matrix(seed + again, graph, block);
    fill(cholesky, graph, dense);
    ASSERT_TRUE(cholesky.factorize());
    const Eigen::VectorXd right = testing::random_vector(seed, dense.rows());
    Eigen::VectorXd x = right;
    cholesky.solve(x);
    EXPECT_LT((x - dense.llt().solve(right)).norm() / right.norm(), kSolveError);
    EXPECT_LT((dense * x - right).norm() / right.norm(), kSolveError);
  }
}

class SparseCholeskyOfScalars : public ::testing::TestWithParam<std::tuple<unsigned, int>> {};

TEST_P(SparseCholeskyOfScalars, SolvesThreeCoordinatesAsOneByOne) {
  const auto [seed, nodes] = GetParam();
  const RaggedRows graph = random_graph(seed, nodes);
  SparseCholesky cholesky;
  cholesky.analyze(graph, 1);
  fill(cholesky, graph, random_matrix(seed, graph, 1));
  ASSERT_TRUE(cholesky.factorize());
  const Eigen::Matrix3Xd right = testing::random_points(seed, nodes);
  Eigen::Matrix3Xd together = right;
  cholesky.solve_coordinates(together);
  for (int c = 0; c < 3; ++c) {
    Eigen::VectorXd alone = right.row(c).transpose();
    cholesky.solve(alone);
    EXPECT_LT((together.row(c).transpose() - alone).norm(), 1e-13 * right.norm());
  }
}

TEST_P(SparseCholeskyOn, RefusesAnIndefiniteMatrix) {
  const auto [seed, nodes, block, order] = GetParam();
  const RaggedRows graph = random_graph(seed, nodes);
  Eigen::MatrixXd dense = random_matrix(seed, graph, block);
  const Eigen::Index bad = static_cast<Eigen::Index>(seed * 7919u) % dense.rows();
  dense(bad, bad) = -1e-3;
  SparseCholesky cholesky;
  cholesky.analyze(graph, block, order);
  fill(cholesky, graph, dense);
  EXPECT_FALSE(cholesky.factorize());
  // Another matrix on the same analysis still works.
  fill(cholesky, graph, random_matrix(seed, graph, block));
  EXPECT_TRUE(cholesky.factorize());
}

TEST_P(SparseCholeskyOn, RefusesAMatrixThatIsNotFinite) {
  const auto [seed, nodes, block, order] = GetParam();
  const RaggedRows graph = random_graph(seed, nodes);
  Eigen::MatrixXd dense = random_matrix(seed, graph, block);
  dense(0, 0) = std::numeric_limits<double>::quiet_NaN();
  SparseCholesky cholesky;
  cholesky.analyze(graph, block, order);
  fill(cholesky, graph, dense);
  EXPECT_FALSE(cholesky.factorize());
}

TEST_P(SparseCholeskyOn, NumbersEveryNodeOnce) {
  const auto [seed, nodes, block, order] = GetParam();
  SparseCholesky cholesky;
  cholesky.analyze(random_graph(seed, nodes), block, order);
  std::vector<int> seen;
  for (int k = 0; k < nodes; ++k) seen.push_back(cholesky.position(k));
  std::sort(seen.begin(), seen.end());
  for (int k = 0; k < nodes; ++k) EXPECT_EQ(seen[static_cast<std::size_t>(k)], k);
}

INSTANTIATE_TEST_SUITE_P(Graphs, SparseCholeskyOn,
                         ::testing::Combine(::testing::Values(1u, 2u, 3u, 4u),
                                            ::testing::Values(1, 2, 13, 60),
                                            ::testing::Values(1, 2, 3),
                                            ::testing::Values(EliminationOrder::kMinimumDegree,
                                                              EliminationOrder::kGiven)));

INSTANTIATE_TEST_SUITE_P(Graphs, SparseCholeskyOfScalars,
                         ::testing::Combine(::testing::Values(1u, 2u, 3u, 4u),
                                            ::testing::Values(1, 2, 13, 60)));

/// Tasks in the order that is farthest from that of one thread.
class Backwards final : public Executor {
 public:
  void run(int count, const std::function<void(int)>& task) override {
    for (int k = count; k-- > 0;) task(k);
    tasks += count;
  }
  int tasks = 0;
};

class SparseCholeskyOfGrid : public ::testing::TestWithParam<int> {};

/// Sec. 3.5: subtrees are solved side by side, and every sum keeps its order.
TEST_P(SparseCholeskyOfGrid, SolvesInPartsWithTheSameBits) {
  const int block = GetParam();
  const RaggedRows graph = build_adjacency(testing::quad_grid(50, 50)).neighbours;
  const Eigen::VectorXd entries = testing::random_vector(1, graph.size());
  SparseCholesky cholesky;
  cholesky.analyze(graph, block);
  cholesky.set_zero();
  const auto set = [&](int i, int j, double value) {
    const BlockSlot slot = cholesky.slot(i, j);
    for (int c = 0; c < block; ++c) {
      cholesky.values()[static_cast<std::size_t>(slot.offset + c * (slot.stride + 1))] = value;
    }
  };
  for (int i = 0; i < graph.size(); ++i) {
    set(i, i, 20.0);
    for (const int j : graph[i]) {
      if (cholesky.position(i) > cholesky.position(j)) set(i, j, entries[i]);
    }
  }
  ASSERT_TRUE(cholesky.factorize());
  Backwards backwards;
  const Eigen::VectorXd right = testing::random_vector(2, block * graph.size());
  Eigen::VectorXd x = right, in_parts = right;
  cholesky.solve(x);
  cholesky.solve(in_parts, &backwards);
  EXPECT_EQ(x, in_parts);
  EXPECT_GT(backwards.tasks, 8);
  if (block > 1) return;
  const Eigen::Matrix3Xd three = testing::random_points(3, graph.size());
  Eigen::Matrix3Xd y = three, y_in_parts = three;
  cholesky.solve_coordinates(y);
  cholesky.solve_coordinates(y_in_parts, &backwards);
  EXPECT_EQ(y, y_in_parts);
}

INSTANTIATE_TEST_SUITE_P(Blocks, SparseCholeskyOfGrid, ::testing::Values(1, 2, 3));

TEST(SparseCholesky, FactorsAnEmptyMatrix) {
  SparseCholesky cholesky;
  cholesky.analyze(RaggedRows{}, 3);
  cholesky.set_zero();
  EXPECT_TRUE(cholesky.factorize());
  Eigen::VectorXd nothing(0);
  cholesky.solve(nothing);
  EXPECT_EQ(cholesky.node_count(), 0);
}

/// The elimination order matters: a grid's factor stays far below a dense one.
TEST(SparseCholesky, KeepsAGridSparse) {
  const Mesh mesh = testing::quad_grid(40, 40);
  const Adjacency adjacency = build_adjacency(mesh);
  SparseCholesky cholesky;
  cholesky.analyze(adjacency.neighbours, 1);
  EXPECT_LT(cholesky.factor_size(), 80'000);  // dense: 1,280,800
}

}  // namespace
}  // namespace planish
