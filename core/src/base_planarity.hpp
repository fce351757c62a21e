// SPDX-License-Identifier: MIT
/// Planarity of the mesh that an edit starts from: measured once, O(n log n).
#pragma once

#include <vector>

#include "planish/mesh.hpp"

namespace planish {

/// One figure per face, sorted, so that "the worst panel outside a set" costs what the set costs.
class FaceRanking {
 public:
  FaceRanking() = default;
  explicit FaceRanking(std::vector<double> values);

  /// 0 for a mesh without faces.
  [[nodiscard]] double worst() const;

  /// Over the faces that are not in `touched`, which ascends; 0 if there are none.
  [[nodiscard]] double worst_outside(const std::vector<int>& touched) const;

 private:
  std::vector<double> values_;  ///< by face
  std::vector<int> order_;      ///< worst first
};

/// [MET-1] and [MET-3] of a mesh, mm/m.
struct BasePlanarity {
  explicit BasePlanarity(const Mesh& mesh);
  FaceRanking mm_per_m, excess;
};

}  // namespace planish
