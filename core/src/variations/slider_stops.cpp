// SPDX-License-Identifier: MIT
#include "planish/variations/slider_stops.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "planish/constraints/corner_shape.hpp"
#include "planish/numeric/index.hpp"

namespace planish {
namespace {

/// s(τ) = c + b τ + a τ².
struct Quadratic {
  double a = 0.0, b = 0.0, c = 0.0;
};

/// The root nearest to 0 on either side.
std::array<double, 2> nearest_roots(const Quadratic& s) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::array<double, 2> nearest{-kNone, kNone};
  const auto take = [&](double root) {
    if (!std::isfinite(root)) return;
    if (root > 0.0) nearest[1] = std::min(nearest[1], root);
    if (root < 0.0) nearest[0] = std::max(nearest[0], root);
  };
  const double discriminant = s.b * s.b - 4.0 * s.a * s.c;
  if (discriminant < 0.0) return nearest;
  // The sum that does not cancel, then Vieta: exact for a = 0 too.
  const double sum = -0.5 * (s.b + std::copysign(std::sqrt(discriminant), s.b));
  if (s.a != 0.0) take(sum / s.a);
  if (sum != 0.0) take(s.c / sum);
  return nearest;
}

/// Where s stays positive, about 0 or nearest to it: beyond a stop the nearer root is that stop,
/// behind the slider.
std::array<double, 2> stretch_of(const Quadratic& s) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto [below, above] = nearest_roots(s);
  if (s.c > 0.0) return {below, above};
  return -below < above ? std::array<double, 2>{-kNone, below}
                        : std::array<double, 2>{above, kNone};
}

/// The points of a corner as the sliders stand, and how they move with one of them.
class MovingPoints {
 public:
  MovingPoints(const Positions& edited, const Subspace& subspace, const Eigen::VectorXd& values)
      : edited_(edited), subspace_(subspace) {
    evaluate(subspace, values, now_);
  }

  [[nodiscard]] RowPoints<3> at_rest(const CornerShape& corner) const {
    RowPoints<3> points;
    for (int k = 0; k < 3; ++k) {
      const int v = corner.vertices[at(k)];
      const auto place = place_of(v);
      if (place < 0) {
        points.col(k) = edited_.col(v);
      } else {
        points.col(k) = now_.col(place);
      }
    }
    return points;
  }

  /// The corner with all sliders at 0.
  [[nodiscard]] RowPoints<3> edited(const CornerShape& corner) const {
    RowPoints<3> points;
    for (int k = 0; k < 3; ++k) points.col(k) = edited_.col(corner.vertices[at(k)]);
    return points;
  }

  [[nodiscard]] RowPoints<3> along(const CornerShape& corner, Eigen::Index slider) const {
    RowPoints<3> moves = RowPoints<3>::Zero();
    for (int k = 0; k < 3; ++k) {
      const auto place = place_of(corner.vertices[at(k)]);
      if (place < 0) continue;
      moves.col(k) = subspace_.scale[slider] * subspace_.basis.col(slider).segment<3>(3 * place);
    }
    return moves;
  }

 private:
  /// The place of a vertex in the support; −1 outside it.
  [[nodiscard]] Eigen::Index place_of(int v) const {
    const auto found = std::lower_bound(subspace_.support.begin(), subspace_.support.end(), v);
    const bool here = found != subspace_.support.end() && *found == v;
    return here ? found - subspace_.support.begin() : -1;
  }

  const Positions& edited_;
  const Subspace& subspace_;
  Positions now_;
};

Quadratic share_along(const CornerShape& corner, const RowPoints<3>& points,
                      const RowPoints<3>& moves) {
  const Eigen::Vector3d in = points.col(1) - points.col(0), out = points.col(2) - points.col(1);
  const Eigen::Vector3d in_moves = moves.col(1) - moves.col(0);
  const Eigen::Vector3d out_moves = moves.col(2) - moves.col(1);
  return {corner.normal.dot(in_moves.cross(out_moves)),
          corner.normal.dot(in.cross(out_moves) + in_moves.cross(out)),
          corner.normal.dot(in.cross(out)) + corner.offset};
}

/// Faces with a vertex of the support, ascending.
std::vector<int> touched_faces(const Mesh& base, const std::vector<int>& support) {
  std::vector<int> faces;
  for (int f = 0; f < base.face_count(); ++f) {
    const auto face = base.face(f);
    const bool touches = std::any_of(face.begin(), face.end(), [&](int v) {
      return std::binary_search(support.begin(), support.end(), v);
    });
    if (touches) faces.push_back(f);
  }
  return faces;
}

}  // namespace

std::vector<SliderRange> slider_ranges(const Mesh& base, const Positions& edited,
                                       const Subspace& subspace, const Eigen::VectorXd& values) {
  const MovingPoints points(edited, subspace, values);
  std::vector<SliderRange> ranges(static_cast<std::size_t>(subspace.dimension()));
  std::vector<CornerShape> corners;
  for (const int f : touched_faces(base, subspace.support)) {
    corners.clear();
    append_corner_shapes(base.positions, base.face(f), corners);
    for (const CornerShape& corner : corners) {
      // What the edit itself has broken stops nothing.
      if (!(residual(corner, points.edited(corner)) > 0.0)) continue;
      const RowPoints<3> now = points.at_rest(corner);
      for (Eigen::Index k = 0; k < values.size(); ++k) {
        const Quadratic share = share_along(corner, now, points.along(corner, k));
        const auto [from, to] = stretch_of(share);
        SliderRange& range = ranges[static_cast<std::size_t>(k)];
        if (values[k] + to < range.upper.value) range.upper = {values[k] + to, f};
        if (values[k] + from > range.lower.value) range.lower = {values[k] + from, f};
      }
    }
  }
  return ranges;
}

}  // namespace planish
