// SPDX-License-Identifier: MIT
/// Orders in which a sparse matrix is eliminated.
#pragma once

#include <vector>

#include "planish/mesh/adjacency.hpp"

namespace planish {

/// A permutation that keeps fill low (approximate minimum degree): entry k is the node eliminated
/// k-th. `graph`: symmetric, without self loops.
[[nodiscard]] std::vector<int> minimum_degree(const RaggedRows& graph);

/// The nodes of a forest, children before parents, each subtree contiguous. `parents`: -1 at roots.
[[nodiscard]] std::vector<int> postorder(const std::vector<int>& parents);

}  // namespace planish
