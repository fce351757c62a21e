// SPDX-License-Identifier: MIT
#include "planish/constraints/corner_shape.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "constraints/panel_triangles.hpp"
#include "numeric/logarithm.hpp"
#include "planish/constraints/vector_pair.hpp"

namespace planish {
namespace {

constexpr double kKeep = 0.05;            ///< κ: the share of g⁰ that no corner goes below
constexpr double kClamp = 0.5;            ///< ŝ: where the barrier begins
constexpr double kLeastAreaShare = 1e-6;  ///< of the squared perimeter: less is no area

/// A triangle of a panel keeps the share κ of its area, and its side.
CornerShape kept_area(const std::array<int, 3>& vertices, const Eigen::Vector3d& normal,
                      double base) {
  return {vertices, normal / (base * (1.0 - kKeep)), -kKeep / (1.0 - kKeep)};
}

/// Corners that keep their sides do not keep a reflex corner from going through a side: the
/// triangles do that lie between corners which are no neighbours.
void append_inner_triangles(const Positions& positions, std::span<const int> face,
                            const Eigen::Vector3d& normal, std::vector<CornerShape>& out) {
  const auto n = static_cast<int>(face.size());
  const Positions outline = positions(Eigen::all, std::vector<int>(face.begin(), face.end()));
  for (const auto& [i, k, j] : panel_triangles(outline, normal)) {
    const int outline_sides =
        (k - i == 1 ? 1 : 0) + (j - k == 1 ? 1 : 0) + (i + n - j == 1 ? 1 : 0);
    if (outline_sides >= 2) continue;  // a corner: it has its row
    const Eigen::Vector3d in = outline.col(k) - outline.col(i);
    const double base = normal.dot(in.cross(Eigen::Vector3d(outline.col(j) - outline.col(k))));
    out.push_back(kept_area({face[static_cast<std::size_t>(i)], face[static_cast<std::size_t>(k)],
                             face[static_cast<std::size_t>(j)]},
                            normal, base));
  }
}

}  // namespace

double residual(const CornerShape& corner, const RowPoints<3>& points) {
  const Eigen::Vector3d in = points.col(1) - points.col(0);
  const Eigen::Vector3d out = points.col(2) - points.col(1);
  return corner.normal.dot(in.cross(out)) + corner.offset;
}

RowPoints<3> gradient(const CornerShape& corner, const RowPoints<3>& points) {
  const Eigen::Vector3d& normal = corner.normal;
  RowPoints<3> result;
  result.col(0) = (points.col(1) - points.col(2)).cross(normal);
  result.col(1) = (points.col(2) - points.col(0)).cross(normal);
  result.col(2) = (points.col(0) - points.col(1)).cross(normal);
  return result;
}

CurvatureBlocks<3, false> hessian(const CornerShape& corner, const RowPoints<3>& /*points*/) {
  const Eigen::Matrix3d twist = cross_matrix(corner.normal);
  return {twist, -twist, twist};
}

Barrier clamped_barrier(double share) {
  if (share >= kClamp) return {};
  if (!(share > 0.0)) return {std::numeric_limits<double>::infinity(), 0.0, 0.0};
  const double below = share - kClamp;
  const double logarithm = natural_logarithm(share / kClamp);
  return {-below * below * logarithm, -2.0 * below * logarithm - below * below / share,
          -2.0 * logarithm - 4.0 * below / share + below * below / (share * share)};
}

void append_corner_shapes(const Positions& positions, std::span<const int> face,
                          std::vector<CornerShape>& out) {
  const std::size_t n = face.size();
  const auto point = [&](std::size_t k) -> Eigen::Vector3d { return positions.col(face[k % n]); };
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  double perimeter = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    area += (point(k) - point(0)).cross(point(k + 1) - point(0));
    perimeter += (point(k + 1) - point(k)).norm();
  }
  const double size = area.norm();
  if (!(size > kLeastAreaShare * perimeter * perimeter)) return;
  const Eigen::Vector3d normal = area / size;
  bool is_reflex = false;
  for (std::size_t k = 0; k < n; ++k) {
    const Eigen::Vector3d in = point(k + n) - point(k + n - 1);
    const Eigen::Vector3d away = point(k + 1) - point(k);
    const double base = normal.dot(in.cross(away));
    const double lengths = in.norm() * away.norm();
    if (!(lengths > 0.0)) continue;
    const std::array<int, 3> corner{face[(k + n - 1) % n], face[k], face[(k + 1) % n]};
    is_reflex = is_reflex || base < -kStraight * lengths;
    if (std::abs(base) > kStraight * lengths) {
      out.push_back(kept_area(corner, normal, base));
    } else {
      out.push_back({corner, normal / (lengths * kStraightTurn), 1.0});
    }
    if (n == 3) return;  // the other two say the same
  }
  if (is_reflex && n > 4) append_inner_triangles(positions, face, normal, out);
}

}  // namespace planish
