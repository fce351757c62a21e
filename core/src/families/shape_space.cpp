// SPDX-License-Identifier: MIT
#include "families/shape_space.hpp"

#include <algorithm>
#include <cmath>

#include "families/smallest_circle.hpp"

namespace planish {
namespace {

/// Distances of the corners from their mean, and half the sides: laid on each other within D, with
/// the means together, two outlines differ by no more than D in each.
Eigen::VectorXd outline_marks(const FamilyShape& points) {
  const Eigen::Index k = points.cols();
  Eigen::VectorXd marks(2 * k);
  for (Eigen::Index i = 0; i < k; ++i) {
    marks(i) = std::sqrt(points.col(i).squaredNorm());
    marks(k + i) = 0.5 * std::sqrt((points.col((i + 1) % k) - points.col(i)).squaredNorm());
  }
  return marks;
}

/// Each kind of mark in order: sorting brings no two lists further apart.
Eigen::VectorXd sorted_by_kind(Eigen::VectorXd marks) {
  const Eigen::Index half = marks.size() / 2;
  std::sort(marks.data(), marks.data() + half);
  std::sort(marks.data() + half, marks.data() + marks.size());
  return marks;
}

/// Another sign where the marks are met in the other order.
double hand_of(const Eigen::VectorXd& marks) {
  const Eigen::Index k = marks.size() / 2;
  double sum = 0.0;
  for (Eigen::Index i = 0; i < k; ++i) {
    sum += marks(i) * marks(i) * (marks(k + i) - marks(k + (i + k - 1) % k));
  }
  return sum;
}

/// Laid on each other with column i on column i + turn: whether the marks allow it.
bool marks_within(const Eigen::VectorXd& marks, const Eigen::VectorXd& other, Eigen::Index turn,
                  double within) {
  const Eigen::Index k = marks.size() / 2;
  for (Eigen::Index i = 0; i < k; ++i) {
    const Eigen::Index j = i + turn < k ? i + turn : i + turn - k;
    if (!(std::abs(marks(i) - other(j)) <= within)) return false;
    if (!(std::abs(marks(k + i) - other(k + j)) <= within)) return false;
  }
  return true;
}

/// What stands at the columns of a cycle, then what stands between them.
Eigen::VectorXd cycle_marks(const FamilyShape& points) {
  Eigen::VectorXd marks(points.size());
  marks << points.row(1).transpose(), points.row(0).transpose();
  return marks;
}

}  // namespace

FamilyShape mirror_image(const FamilyShape& shape, ShapeMeasure measure) {
  const Eigen::Index k = shape.cols();
  FamilyShape image(2, k);
  for (Eigen::Index i = 0; i < k; ++i) {
    const Eigen::Index back = (k - i) % k;
    if (measure == ShapeMeasure::kOutline) {
      image.col(i) << shape(0, back), -shape(1, back);
    } else {
      image.col(i) << shape(0, k - 1 - i), shape(1, back);
    }
  }
  return image;
}

MeasuredShape ShapeSpace::measured(const FamilyShape& shape) const {
  const bool outline = measure_ == ShapeMeasure::kOutline;
  MeasuredShape result;
  result.points = shape;
  if (outline) result.points.colwise() -= Eigen::Vector2d(shape.rowwise().mean());
  result.marks = outline ? outline_marks(result.points) : cycle_marks(result.points);
  result.key = sorted_by_kind(result.marks);
  result.hand = hand_of(result.marks);
  if (!mirrored_) return result;
  result.mirrored = mirror_image(result.points, measure_);
  result.mirrored_marks = outline ? outline_marks(result.mirrored) : cycle_marks(result.mirrored);
  return result;
}

void ShapeSpace::align(const FamilyShape& points, const FamilyShape& other, int turn,
                       ShapePlacement& placement) const {
  const Eigen::Index k = points.cols();
  double along = 0.0, across = 0.0;
  const auto on = [&](Eigen::Index i) { return i + turn < k ? i + turn : i + turn - k; };
  if (measure_ == ShapeMeasure::kOutline) {
    for (Eigen::Index i = 0; i < k; ++i) {
      const Eigen::Index j = on(i);
      along += other(0, j) * points(0, i) + other(1, j) * points(1, i);
      across += other(0, j) * points(1, i) - other(1, j) * points(0, i);
    }
  }
  const double length = std::sqrt(along * along + across * across);
  placement.turn = turn;
  placement.cosine = length > 0.0 ? along / length : 1.0;
  placement.sine = length > 0.0 ? across / length : 0.0;
  double farthest = 0.0;
  for (Eigen::Index i = 0; i < k; ++i) {
    const Eigen::Index j = on(i);
    if (measure_ == ShapeMeasure::kCycle) {
      farthest = std::max(
          {farthest, std::abs(points(0, i) - other(0, j)), std::abs(points(1, i) - other(1, j))});
      continue;
    }
    const double x = placement.cosine * other(0, j) - placement.sine * other(1, j) - points(0, i);
    const double y = placement.sine * other(0, j) + placement.cosine * other(1, j) - points(1, i);
    farthest = std::max(farthest, x * x + y * y);
  }
  placement.distance = measure_ == ShapeMeasure::kCycle ? farthest : std::sqrt(farthest);
}

void ShapeSpace::try_turns(const FamilyShape& points, const Eigen::VectorXd& marks,
                           const MeasuredShape& other, double within, bool mirrored,
                           ShapePlacement& best) {
  for (int turn = 0; turn < static_cast<int>(points.cols()); ++turn) {
    if (!marks_within(marks, other.marks, turn, within)) continue;
    ShapePlacement placement;
    placement.mirrored = mirrored;
    align(points, other.points, turn, placement);
    ++alignments_;
    if (placement.distance < best.distance - same_) best = placement;
  }
}

ShapePlacement ShapeSpace::place(const MeasuredShape& shape, const MeasuredShape& other,
                                 double within) {
  ShapePlacement best;
  if (shape.points.cols() != other.points.cols()) return best;
  try_turns(shape.points, shape.marks, other, within, false, best);
  if (mirrored_) try_turns(shape.mirrored, shape.mirrored_marks, other, within, true, best);
  if (!(best.distance <= within)) best.distance = std::numeric_limits<double>::infinity();
  return best;
}

FamilyShape ShapeSpace::laid(const MeasuredShape& shape, const ShapePlacement& placement) const {
  const FamilyShape& points = placement.mirrored ? shape.mirrored : shape.points;
  const Eigen::Index k = points.cols();
  FamilyShape result(2, k);
  for (Eigen::Index i = 0; i < k; ++i) {
    const double c = placement.cosine, s = placement.sine;
    result.col((i + placement.turn) % k) << c * points(0, i) + s * points(1, i),
        c * points(1, i) - s * points(0, i);
  }
  return result;
}

FamilyShape ShapeSpace::centre(const Eigen::MatrixXd& laid) const {
  FamilyShape result(2, laid.rows() / 2);
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const auto place = laid.middleRows<2>(2 * i);
    if (measure_ == ShapeMeasure::kOutline) {
      result.col(i) = smallest_circle_centre(place);
    } else {
      result.col(i) = 0.5 * (place.rowwise().minCoeff() + place.rowwise().maxCoeff());
    }
  }
  return result;
}

}  // namespace planish
