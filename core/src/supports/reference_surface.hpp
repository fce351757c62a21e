// SPDX-License-Identifier: MIT
/// A model that points stand on: where it is nearest to a point, and which way is up there. [SUP-4]
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/mesh/panel_boxes.hpp"
#include "planish/obstacles/context_mesh.hpp"
#include "supports/surface_sites.hpp"

namespace planish {

/// The place of a side's facets that is nearest to a point.
struct SurfaceFoot {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  SurfaceHeight height;  ///< of the point, above the surface that is smooth
};

/// A surface as its facets show it and as they mean it: on the facets themselves flat panels could
/// not move at all.
class ReferenceSurface {
 public:
  explicit ReferenceSurface(const Mesh& mesh);

  /// The sides that are nearest to a point: several along a sharp edge.
  [[nodiscard]] std::vector<int> sides_at(const Eigen::Vector3d& point, std::size_t most) const;

  /// The foot of a point on a side. @param near a place on it; the better, the sooner
  [[nodiscard]] SurfaceFoot foot(const Eigen::Vector3d& point, int side,
                                 const Eigen::Vector3d& near) const;

  /// A place of a side near a point, for foot().
  [[nodiscard]] Eigen::Vector3d somewhere_near(const Eigen::Vector3d& point, int side) const;

  /// How far the facets are.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const;

 private:
  static constexpr int kAnySide = -1;
  struct FacetPlace {
    int facet = -1;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
  };

  [[nodiscard]] bool is_of(int facet, int side) const;
  [[nodiscard]] FacetPlace nearest(const Eigen::Vector3d& point, int side,
                                   const Eigen::Vector3d& near) const;
  [[nodiscard]] Eigen::Vector3d nearest_place(int facet, const Eigen::Vector3d& point) const;

  Mesh triangles_;
  std::vector<int> panel_of_;  ///< of each triangle
  PanelBoxes boxes_;
  SurfaceSites sites_;
  double step_;  ///< a mean side
};

[[nodiscard]] Mesh to_mesh(const ContextMesh& context);

}  // namespace planish
