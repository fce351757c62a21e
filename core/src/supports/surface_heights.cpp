// SPDX-License-Identifier: MIT
#include "supports/surface_heights.hpp"

#include <algorithm>
#include <cmath>

#include "planish/supports/vertex_slides.hpp"
#include "supports/reference_surface.hpp"

namespace planish {

std::vector<double> ways_off_surface(const PointSupport& support, const Mesh& base,
                                     const std::vector<int>& points, const Positions& shape) {
  const ReferenceSurface surface(support.surface.points.empty() ? base : to_mesh(support.surface));
  std::vector<double> ways;
  for (const int v : points) {
    const Eigen::Vector3d was = base.positions.col(v), is = shape.col(v);
    ways.push_back(0.0);
    if (is == was) continue;
    for (const int side : surface.sides_at(was, kMostSurfaceRows)) {
      const SurfaceFoot foot = surface.foot(was, side, surface.somewhere_near(was, side));
      const double height = surface.foot(is, side, foot.place).height.value;
      ways.back() = std::max(ways.back(), std::abs(height - foot.height.value));
    }
  }
  return ways;
}

std::optional<FarPoint> far_from_surface(const PointSupport& support, const Mesh& mesh,
                                         double most) {
  if (support.surface.points.empty()) return std::nullopt;  // it is what it is on
  const ReferenceSurface surface(to_mesh(support.surface));
  for (const int v : points_of(support, mesh)) {
    const double distance = surface.distance(mesh.positions.col(v));
    if (!(distance <= most)) return FarPoint{v, distance};
  }
  return std::nullopt;
}

}  // namespace planish
