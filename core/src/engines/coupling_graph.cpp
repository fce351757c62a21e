// SPDX-License-Identifier: MIT
#include "engines/coupling_graph.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "planish/numeric/index.hpp"

namespace planish {

void Cliques::add(std::span<const int> vertices) {
  lists_.values.insert(lists_.values.end(), vertices.begin(), vertices.end());
  lists_.offsets.push_back(static_cast<int>(lists_.values.size()));
}

void Cliques::add(int a, int b) { add(std::array{a, b}); }

RaggedRows Cliques::graph(int count) const {
  const auto for_each_pair = [&](const auto& visit) {
    for (int list = 0; list < lists_.size(); ++list) {
      const auto vertices = lists_[list];
      for (std::size_t k = 0; k < vertices.size(); ++k) {
        for (std::size_t l = 0; l < k; ++l) {
          const int a = vertices[k], b = vertices[l];
          if (a < count && b < count && a != b) visit(a, b);
        }
      }
    }
  };
  // Room is counted first, so that no list grows.
  std::vector<int> begin(at(count) + 1, 0);
  for_each_pair([&](int a, int b) {
    ++begin[at(a) + 1];
    ++begin[at(b) + 1];
  });
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<int> pairs(at(begin.back()));
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for_each_pair([&](int a, int b) {
    pairs[at(next[at(a)]++)] = b;
    pairs[at(next[at(b)]++)] = a;
  });
  RaggedRows graph;
  for (int v = 0; v < count; ++v) {
    const auto first = pairs.begin() + begin[at(v)];
    const auto last = pairs.begin() + begin[at(v) + 1];
    std::sort(first, last);
    graph.values.insert(graph.values.end(), first, std::unique(first, last));
    graph.offsets.push_back(static_cast<int>(graph.values.size()));
  }
  return graph;
}

}  // namespace planish
