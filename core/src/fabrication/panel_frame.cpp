// SPDX-License-Identifier: MIT
#include "planish/fabrication/panel_frame.hpp"

#include <Eigen/Geometry>

#include "planish/constraints/planar_polygon.hpp"
#include "planish/index.hpp"
#include "planish/panel_health.hpp"

namespace planish {
namespace {

/// From one end of `side` to the other.
Eigen::Vector3d along(const Positions& positions, std::span<const int> face, int side) {
  const std::size_t next = (at(side) + 1) % face.size();
  return positions.col(face[next]) - positions.col(face[at(side)]);
}

}  // namespace

Eigen::Vector3d panel_normal(const Positions& positions, std::span<const int> face) {
  const Eigen::Vector3d area = area_vector(positions, face).stableNormalized();
  if (face.size() == 3 && !area.isZero(0.0)) return area;
  Eigen::Matrix3Xd corners(3, static_cast<Eigen::Index>(face.size()));
  for (std::size_t k = 0; k < face.size(); ++k) {
    corners.col(static_cast<Eigen::Index>(k)) = positions.col(face[k]) - positions.col(face[0]);
  }
  const double size = corners.cwiseAbs().maxCoeff();  // huge coordinates must not overflow
  if (size > 0.0) corners /= size;
  Eigen::Vector3d normal = area;
  project_to_plane_centred(corners, normal);
  if (!normal.allFinite() || normal.isZero(0.0)) return Eigen::Vector3d::UnitZ();
  return normal.dot(area) < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

int longest_side(const Positions& positions, std::span<const int> face) {
  constexpr double kEqual = 1.0 + 1e-9;
  int longest = 0;
  for (int side = 1; side < static_cast<int>(face.size()); ++side) {
    const double length = along(positions, face, side).stableNorm();
    if (length > kEqual * along(positions, face, longest).stableNorm()) longest = side;
  }
  return longest;
}

PanelFrame panel_frame(const Positions& positions, std::span<const int> face, int side) {
  PanelFrame frame;
  frame.origin = positions.col(face[0]);
  frame.normal = panel_normal(positions, face);
  const Eigen::Vector3d edge = along(positions, face, side).stableNormalized();
  const Eigen::Vector3d across = frame.normal.cross(edge);
  const bool usable = across.norm() > 0.5;  // a panel without length or plane has no direction
  frame.y = usable ? Eigen::Vector3d(across.normalized()) : frame.normal.unitOrthogonal();
  frame.x = frame.y.cross(frame.normal).normalized();
  return frame;
}

}  // namespace planish
