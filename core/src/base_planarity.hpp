// SPDX-License-Identifier: MIT
/// Planarity of the mesh that an edit starts from: measured once, O(n log n).
#pragma once

#include <vector>

#include "planish/mesh.hpp"

namespace planish {

/// Faces sorted by [MET-1], so that "the worst panel outside a set" costs what the set costs.
class BasePlanarity {
 public:
  explicit BasePlanarity(const Mesh& mesh);

  /// mm/m; 0 for a mesh without faces.
  [[nodiscard]] double worst() const { return order_.empty() ? 0.0 : values_[first()]; }

  /// mm/m over the faces that are not in `touched`, any order; 0 if there are none.
  [[nodiscard]] double worst_outside(std::vector<int> touched) const;

 private:
  [[nodiscard]] std::size_t first() const { return static_cast<std::size_t>(order_.front()); }

  std::vector<double> values_;  ///< by face
  std::vector<int> order_;      ///< worst first
};

}  // namespace planish
