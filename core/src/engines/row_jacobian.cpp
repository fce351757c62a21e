// SPDX-License-Identifier: MIT
#include "engines/row_jacobian.hpp"

#include <algorithm>

namespace planish {

void RowJacobian::find_slides(const Patch& patch) {
  free_count_ = patch.free_count;
  gradients_.setZero(3, static_cast<Eigen::Index>(vertices_.values.size()));
  slide_entries_.clear();
  if (patch.slides.empty()) return;
  for (std::size_t k = 0; k < vertices_.values.size(); ++k) {
    const auto found =
        std::lower_bound(patch.slides.begin(), patch.slides.end(), vertices_.values[k],
                         [](const Slide& slide, int v) { return slide.vertex < v; });
    if (found == patch.slides.end() || found->vertex != vertices_.values[k]) continue;
    slide_entries_.push_back({static_cast<Eigen::Index>(k), found->track.along});
  }
}

void RowJacobian::slide() {
  for (const SlideEntry& entry : slide_entries_) {
    const Eigen::Vector3d whole = gradients_.col(entry.column);
    gradients_.col(entry.column) = entry.along * whole;
  }
}

void RowJacobian::evaluate(const Patch& patch, const Eigen::Matrix3Xd& displacement) {
  patch.equations.for_each(
      [&](int e, const auto& row) { set(e, gradient(row, corners_at(patch, displacement, row))); });
  slide();
}

double RowJacobian::apply(int row, const Eigen::Matrix3Xd& delta) const {
  double sum = 0.0;
  for (int k = vertices_.offsets[at(row)]; k < vertices_.offsets[at(row) + 1]; ++k) {
    const int v = vertices_.values[at(k)];
    if (v < free_count_) sum += gradients_.col(k).dot(delta.col(v));
  }
  return sum;
}

void RowJacobian::apply(const Eigen::Matrix3Xd& delta, Eigen::VectorXd& out) const {
  out.resize(size());
  for (int e = 0; e < size(); ++e) out[e] = apply(e, delta);
}

Eigen::Matrix3Xd RowJacobian::transposed(int row) const {
  Eigen::Matrix3Xd out = Eigen::Matrix3Xd::Zero(3, free_count_);
  for (int k = vertices_.offsets[at(row)]; k < vertices_.offsets[at(row) + 1]; ++k) {
    const int v = vertices_.values[at(k)];
    if (v < free_count_) out.col(v) += gradients_.col(k);
  }
  return out;
}

void RowJacobian::add_transposed(const Eigen::VectorXd& y, Eigen::Matrix3Xd& out) const {
  for (int e = 0; e < size(); ++e) {
    for (int k = vertices_.offsets[at(e)]; k < vertices_.offsets[at(e) + 1]; ++k) {
      const int v = vertices_.values[at(k)];
      if (v < free_count_) out.col(v) += y[e] * gradients_.col(k);
    }
  }
}

double RowJacobian::product(int row, int other, double start) const {
  double sum = start;
  for (int k = vertices_.offsets[at(row)]; k < vertices_.offsets[at(row) + 1]; ++k) {
    const int v = vertices_.values[at(k)];
    if (v >= free_count_) continue;
    for (int l = vertices_.offsets[at(other)]; l < vertices_.offsets[at(other) + 1]; ++l) {
      if (vertices_.values[at(l)] == v) sum += gradients_.col(k).dot(gradients_.col(l));
    }
  }
  return sum;
}

}  // namespace planish
