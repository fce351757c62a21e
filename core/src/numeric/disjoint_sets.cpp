// SPDX-License-Identifier: MIT
#include "numeric/disjoint_sets.hpp"

#include <numeric>

namespace planish {

DisjointSets::DisjointSets(int count)
    : parents_(static_cast<std::size_t>(count)), flips_(static_cast<std::size_t>(count), 0) {
  std::iota(parents_.begin(), parents_.end(), 0);
}

int DisjointSets::find(int element) {
  auto at = static_cast<std::size_t>(element);
  while (static_cast<std::size_t>(parents_[at]) != at) {
    const auto parent = static_cast<std::size_t>(parents_[at]);
    // Path halving: the grandparent becomes the parent, parities add up.
    flips_[at] = static_cast<char>(flips_[at] ^ flips_[parent]);
    parents_[at] = parents_[parent];
    at = static_cast<std::size_t>(parents_[at]);
  }
  return static_cast<int>(at);
}

bool DisjointSets::unite(int a, int b, bool flipped) {
  const int roots[2] = {find(a), find(b)};
  // After find() an element may still be two steps below its root; walk the rest for the parity.
  char parity = flipped ? 1 : 0;
  for (const int start : {a, b}) {
    auto at = static_cast<std::size_t>(start);
    while (static_cast<std::size_t>(parents_[at]) != at) {
      parity = static_cast<char>(parity ^ flips_[at]);
      at = static_cast<std::size_t>(parents_[at]);
    }
  }
  if (roots[0] == roots[1]) return parity == 0;
  // The larger index hangs below the smaller one: no ranks needed, since halving alone gives
  // O(log n) amortised, and the representative is the first element of its set.
  const bool first_wins = roots[0] < roots[1];
  const auto child = static_cast<std::size_t>(first_wins ? roots[1] : roots[0]);
  parents_[child] = first_wins ? roots[0] : roots[1];
  flips_[child] = parity;
  return true;
}

}  // namespace planish
