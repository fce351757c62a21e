// SPDX-License-Identifier: MIT
/// The sparsity pattern of a matrix on a patch's free vertices.
#pragma once

#include <span>

#include "planish/mesh/adjacency.hpp"

namespace planish {

/// Lists of vertices, each coupled with all others of its list.
class Cliques {
 public:
  void add(std::span<const int> vertices);
  void add(int a, int b);

  /// Symmetric adjacency without self loops, rows ascending; pairs with a vertex of `count` or more
  /// (the halo) are left out.
  [[nodiscard]] RaggedRows graph(int count) const;

 private:
  RaggedRows lists_;
};

}  // namespace planish
