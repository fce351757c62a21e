// SPDX-License-Identifier: MIT
#include "problem/shape_slides.hpp"

#include <algorithm>

#include "planish/numeric/index.hpp"

namespace planish {

ShapeSlides::ShapeSlides(const Mesh& base, const Positions& shape,
                         const std::vector<PointSupport>& supports, double unit)
    : base_(base),
      shape_(shape),
      from_((shape - base.positions) / unit),
      unit_(unit),
      slides_(base_, supports, unit) {
  slides_.stand(from_);
}

void ShapeSlides::hold(EditProblem& problem) const {
  problem.slides = &slides_;
  problem.slides_from = &from_;
}

Eigen::Matrix3Xd ShapeSlides::from_base(std::span<const int> vertices,
                                        const Eigen::Matrix3Xd& displacement) const {
  Eigen::Matrix3Xd moved = displacement;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    moved.col(static_cast<Eigen::Index>(k)) += from_.col(vertices[k]);
  }
  return moved;
}

bool ShapeSlides::follow(std::span<const int> vertices, const Eigen::Matrix3Xd& displacement) {
  if (!slides_.has_turning_tracks()) return false;
  return slides_.follow(vertices, from_base(vertices, displacement));
}

bool ShapeSlides::holds(std::span<const int> vertices, const Eigen::Matrix3Xd& displacement) const {
  const Eigen::Matrix3Xd moved = from_base(vertices, displacement);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (!slides_.holds(vertices[k], moved.col(static_cast<Eigen::Index>(k)))) return false;
  }
  return true;
}

Positions ShapeSlides::shape_on_supports() const {
  Positions shape = shape_;
  for (int v = 0; v < base_.vertex_count(); ++v) {
    const Eigen::Vector3d d = from_.col(v);
    if (d.isZero(0.0)) continue;
    Eigen::Vector3d place = slides_.nearest(v, d);
    if (slides_.has_feet()) place = slides_.on_surface(v, place);
    if (place != d) shape.col(v) = base_.positions.col(v) + unit_ * place;
  }
  return shape;
}

bool hold_points(const std::vector<PointSupport>& supports) {
  return !std::all_of(supports.begin(), supports.end(), is_spring);
}

}  // namespace planish
