// SPDX-License-Identifier: MIT
#include "base_planarity.hpp"

#include <algorithm>
#include <numeric>

#include "planish/metrics.hpp"

namespace planish {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

BasePlanarity::BasePlanarity(const Mesh& mesh)
    : values_(at(mesh.face_count())), order_(values_.size()) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    values_[at(f)] = face_planarity(mesh.positions, mesh.face(f)).mm_per_m;
  }
  std::iota(order_.begin(), order_.end(), 0);
  std::stable_sort(order_.begin(), order_.end(),
                   [&](int a, int b) { return values_[at(a)] > values_[at(b)]; });
}

double BasePlanarity::worst_outside(std::vector<int> touched) const {
  std::sort(touched.begin(), touched.end());
  for (const int f : order_) {
    if (!std::binary_search(touched.begin(), touched.end(), f)) return values_[at(f)];
  }
  return 0.0;
}

}  // namespace planish
