// SPDX-License-Identifier: MIT
/// Union-find with parity: which elements belong together, and which of them are flipped.
#pragma once

#include <vector>

namespace planish {

/// Elements 0 … count − 1, at first each its own set.
class DisjointSets {
 public:
  explicit DisjointSets(int count);

  /// Puts a and b into one set, b flipped against a if `flipped`. False if they were in one set
  /// already with the other parity.
  bool unite(int a, int b, bool flipped = false);

  /// The set that `element` belongs to, as its representative's index.
  [[nodiscard]] int find(int element);

 private:
  std::vector<int> parents_;
  std::vector<char> flips_;  ///< against the parent
};

}  // namespace planish
