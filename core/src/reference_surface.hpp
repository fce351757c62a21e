// SPDX-License-Identifier: MIT
/// A model that points stand on: where it is nearest to a point, and which way is up there. [SUP-4]
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planish/context_mesh.hpp"
#include "planish/mesh.hpp"
#include "planish/panel_boxes.hpp"

namespace planish {

/// The place of the facets that is nearest to a point.
struct SurfaceFoot {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double distance = 0.0;                              ///< of the point, from there
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of length 1, mixed of those of corners
  double height = 0.0;  ///< of the point along the normal, above the surface that is smooth
};

/// The smooth surface that facets stand for: flat panels that moved on the facets themselves could
/// not move at all. Above a place of a facet it is at the mean of where the corners' tangent planes
/// are (Phong tessellation, Boubekeur and Alexa 2008), their normals means of the facets around
/// that are within 30°, so that what is flat stays flat and what is sharp stays sharp.
class ReferenceSurface {
 public:
  explicit ReferenceSurface(const Mesh& mesh);

  /// @param near a place on the surface; the better, the sooner
  [[nodiscard]] SurfaceFoot foot(const Eigen::Vector3d& point, const Eigen::Vector3d& near) const;

  /// A place on it near a point, for foot().
  [[nodiscard]] Eigen::Vector3d somewhere_near(const Eigen::Vector3d& point) const;

 private:
  Mesh triangles_;
  Eigen::Matrix3Xd normals_;  ///< of each corner of each triangle, of length 1
  PanelBoxes boxes_;
  double step_;  ///< a mean side
};

[[nodiscard]] Mesh to_mesh(const ContextMesh& context);

}  // namespace planish
