// SPDX-License-Identifier: MIT
#include "variations/allowed_motions.hpp"

#include <algorithm>
#include <span>

namespace planish {

AllowedMotions::AllowedMotions(const Mesh& base, const Positions& edited,
                               const KeptByVariations& keeps, double unit)
    : symmetry_(keeps.symmetry) {
  if (hold_points(keeps.supports)) slides_.emplace(base, edited, keeps.supports, unit);
}

void AllowedMotions::hold(EditProblem& problem) const {
  if (slides_) slides_->hold(problem);
}

void AllowedMotions::leave_out_held(const std::vector<int>& held,
                                    std::vector<int>& vertices) const {
  std::vector<int> sorted = held;
  std::sort(sorted.begin(), sorted.end());
  std::erase_if(vertices, [&](int v) {
    const bool is_held = std::binary_search(sorted.begin(), sorted.end(), v);
    return is_held || (slides_ && slides_->slides().rests(v));
  });
  if (symmetry_ == nullptr) return;
  const std::vector<int> left = vertices;
  std::erase_if(vertices, [&](int v) {
    return std::any_of(symmetry_->operations.begin(), symmetry_->operations.end(),
                       [&](const SymmetryOperation& one) {
                         return !std::binary_search(left.begin(), left.end(), one.image[at(v)]);
                       });
  });
}

void AllowedMotions::even_out(const Patch& patch, Eigen::Matrix3Xd& t) const {
  if (symmetry_ == nullptr) return;
  even_out_directions(*symmetry_, std::span(patch.vertices).first(at(patch.free_count)), t);
}

bool AllowedMotions::even_out_found(const Patch& patch, Eigen::Matrix3Xd& t) const {
  constexpr double kRounding = 1e-8;
  if (symmetry_ == nullptr) return true;
  const Eigen::Matrix3Xd found = t;
  even_out(patch, t);
  t /= t.norm();
  return (t - found).cwiseAbs().maxCoeff() <= kRounding;
}

Eigen::RowVectorXd AllowedMotions::first_image(const Patch& patch, const Positions& points,
                                               const Eigen::Matrix3Xd& edit,
                                               Eigen::RowVectorXd footprint) const {
  if (symmetry_ == nullptr) return footprint;
  Eigen::Index middle = 0;
  edit.colwise().norm().maxCoeff(&middle);
  const auto point = [&](int v) { return points.col(v); };
  const int moves_most = patch.vertices[at(middle)];
  for (Eigen::Index k = 0; k < footprint.size(); ++k) {
    const int v = patch.vertices[at(k)];
    const double own = (point(v) - point(moves_most)).norm();
    for_each_image(moves_most, [&](int image) {
      if ((point(v) - point(image)).norm() < own) footprint[k] = 0.0;
    });
  }
  return footprint;
}

void put_along_tracks(const Patch& patch, Eigen::Matrix3Xd& t) {
  for (const Slide& slide : patch.slides) {
    const Eigen::Vector3d whole = t.col(slide.vertex);
    t.col(slide.vertex) = slide.track.along * whole;
  }
}

}  // namespace planish
