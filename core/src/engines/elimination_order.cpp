// SPDX-License-Identifier: MIT
#include "engines/elimination_order.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include "planish/numeric/index.hpp"

namespace planish {

std::vector<int> minimum_degree(const RaggedRows& graph) {
  const int n = graph.size();
  using Pattern = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
  Pattern pattern(n, n);
  std::vector<int> sizes(at(n));
  for (int v = 0; v < n; ++v) sizes[at(v)] = static_cast<int>(graph[v].size()) + 1;
  pattern.reserve(sizes);
  for (int v = 0; v < n; ++v) {
    pattern.insert(v, v) = 1.0;
    for (const int w : graph[v]) pattern.insert(w, v) = 1.0;
  }
  pattern.makeCompressed();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);
  // Eigen returns the inverse: column k of the reordered matrix is column order[k].
  return {order.indices().data(), order.indices().data() + n};
}

std::vector<int> postorder(const std::vector<int>& parents) {
  const int n = static_cast<int>(parents.size());
  std::vector<int> first_child(at(n), -1);
  std::vector<int> next_sibling(at(n), -1);
  std::vector<int> order;
  order.reserve(at(n));
  for (int v = n - 1; v >= 0; --v) {
    if (parents[at(v)] < 0) continue;
    next_sibling[at(v)] = first_child[at(parents[at(v)])];
    first_child[at(parents[at(v)])] = v;
  }
  std::vector<int> stack;
  for (int root = 0; root < n; ++root) {
    if (parents[at(root)] >= 0) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int v = stack.back();
      const int child = first_child[at(v)];
      if (child >= 0) {
        first_child[at(v)] = next_sibling[at(child)];
        stack.push_back(child);
      } else {
        stack.pop_back();
        order.push_back(v);
      }
    }
  }
  return order;
}

}  // namespace planish
