// SPDX-License-Identifier: MIT
#include "base_planarity.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "planish/index.hpp"
#include "planish/metrics.hpp"

namespace planish {
FaceRanking::FaceRanking(std::vector<double> values)
    : values_(std::move(values)), order_(values_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::stable_sort(order_.begin(), order_.end(),
                   [&](int a, int b) { return values_[at(a)] > values_[at(b)]; });
}

double FaceRanking::worst() const { return order_.empty() ? 0.0 : values_[at(order_.front())]; }

double FaceRanking::worst_outside(const std::vector<int>& touched) const {
  for (const int f : order_) {
    if (!std::binary_search(touched.begin(), touched.end(), f)) return values_[at(f)];
  }
  return 0.0;
}

BasePlanarity::BasePlanarity(const Mesh& mesh) {
  std::vector<double> gaps, excesses;
  gaps.reserve(at(mesh.face_count()));
  excesses.reserve(at(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    const FacePlanarity flatness = face_planarity(mesh.positions, mesh.face(f));
    gaps.push_back(flatness.mm_per_m);
    excesses.push_back(flatness.excess);
  }
  mm_per_m = FaceRanking(std::move(gaps));
  excess = FaceRanking(std::move(excesses));
}

}  // namespace planish
