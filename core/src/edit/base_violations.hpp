// SPDX-License-Identifier: MIT
/// How far the mesh that an edit starts from is from its constraints: measured once, O(n log n).
#pragma once

#include <array>
#include <vector>

#include "planish/constraints/kept_kinds.hpp"
#include "planish/problem/problem.hpp"

namespace planish {

/// One figure per element, sorted, so that "the worst outside a set" costs what the set costs.
class ElementRanking {
 public:
  ElementRanking() = default;
  explicit ElementRanking(std::vector<double> values);

  /// 0 for a mesh without elements.
  [[nodiscard]] double worst() const;

  /// The worst over the elements that are not in `touched`, which ascends; 0 if there are none.
  [[nodiscard]] double worst_outside(const std::vector<int>& touched) const;

 private:
  std::vector<double> values_;  ///< by element
  std::vector<int> order_;      ///< worst first
};

/// What the kept kinds measure on a mesh, element by element.
class BaseViolations {
 public:
  explicit BaseViolations(const MeshModel& model);

  [[nodiscard]] Violation worst(std::size_t kind) const {
    return {measures_[kind].worst(), excesses_[kind].worst()};
  }
  /// The worst of one kind over the elements that are not in `touched`, which ascends.
  [[nodiscard]] Violation worst_outside(std::size_t kind, const std::vector<int>& touched) const {
    return {measures_[kind].worst_outside(touched), excesses_[kind].worst_outside(touched)};
  }

 private:
  std::array<ElementRanking, ConstraintKinds::kCount> measures_, excesses_;
};

}  // namespace planish
