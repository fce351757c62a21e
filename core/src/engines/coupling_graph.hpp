// SPDX-License-Identifier: MIT
/// The sparsity pattern of a matrix on a patch's free vertices.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "planish/adjacency.hpp"
#include "planish/index.hpp"

namespace planish {

/// Calls join(a, b) for every pair of a list.
template <class List, class Join>
void join_all(const List& list, const Join& join) {
  for (std::size_t k = 0; k < list.size(); ++k) {
    for (std::size_t l = 0; l < k; ++l) join(list[k], list[l]);
  }
}

/// Symmetric adjacency without self loops, rows ascending; pairs with a vertex of `count` or more
/// (the halo) are left out.
/// @param each_pair called twice as each_pair(join), with the same pairs both times: room is
/// counted
///                  first, so that no list grows
template <class EachPair>
RaggedRows coupling_graph(int count, const EachPair& each_pair) {
  const auto counts = [&](int a, int b) { return a < count && b < count && a != b; };
  std::vector<int> begin(at(count) + 1, 0);
  each_pair([&](int a, int b) {
    if (!counts(a, b)) return;
    ++begin[at(a) + 1];
    ++begin[at(b) + 1];
  });
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<int> pairs(at(begin.back()));
  std::vector<int> next(begin.begin(), begin.end() - 1);
  each_pair([&](int a, int b) {
    if (!counts(a, b)) return;
    pairs[at(next[at(a)]++)] = b;
    pairs[at(next[at(b)]++)] = a;
  });
  RaggedRows graph;
  graph.offsets.assign(1, 0);
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
