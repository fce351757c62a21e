// SPDX-License-Identifier: MIT
#include "edit/base_violations.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "planish/constraints/elements.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
ElementRanking::ElementRanking(std::vector<double> values)
    : values_(std::move(values)), order_(values_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::stable_sort(order_.begin(), order_.end(),
                   [&](int a, int b) { return values_[at(a)] > values_[at(b)]; });
}

double ElementRanking::worst() const { return order_.empty() ? 0.0 : values_[at(order_.front())]; }

double ElementRanking::worst_outside(const std::vector<int>& touched) const {
  for (const int f : order_) {
    if (!std::binary_search(touched.begin(), touched.end(), f)) return values_[at(f)];
  }
  return 0.0;
}

BaseViolations::BaseViolations(const MeshModel& model) {
  MeshElements elements(model.mesh, model.adjacency);
  model.kept.for_each([&](auto tag, std::size_t kind) {
    using Kind = typename decltype(tag)::type;
    const int count = elements.count(Kind::kElement);
    std::vector<double> measures, excesses;
    measures.reserve(at(count));
    excesses.reserve(at(count));
    for (int e = 0; e < count; ++e) {
      const Violation here =
          model.violation<Kind>(e, model.mesh.positions, elements.of(Kind::kElement, e));
      measures.push_back(here.measure);
      excesses.push_back(here.excess);
    }
    measures_[kind] = ElementRanking(std::move(measures));
    excesses_[kind] = ElementRanking(std::move(excesses));
  });
}

}  // namespace planish
