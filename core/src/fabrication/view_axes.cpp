// SPDX-License-Identifier: MIT
#include "fabrication/view_axes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace planish {

ViewAxes view_from(const Eigen::Vector3d& towards) {
  const bool from_above = std::abs(towards.z()) > 0.9;
  const Eigen::Vector3d hint = from_above ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d right = hint.cross(towards).normalized();
  return {right, towards.cross(right), towards};
}

SeenPanel see_panel(const Mesh& mesh, int face, const ViewAxes& view) {
  const auto corners = mesh.face(face);
  SeenPanel seen{face, 0.0, Outline(2, static_cast<Eigen::Index>(corners.size()))};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector3d p = mesh.positions.col(corners[k]);
    seen.outline.col(static_cast<Eigen::Index>(k)) = view.seen(p);
    seen.depth += view.towards.dot(p) / static_cast<double>(corners.size());
  }
  return seen;
}

void sort_by_depth(std::vector<SeenPanel>& panels) {
  std::stable_sort(panels.begin(), panels.end(),
                   [](const SeenPanel& a, const SeenPanel& b) { return a.depth < b.depth; });
}

PlanarBox box_of(std::span<const SeenPanel> panels) {
  if (panels.empty()) return {};
  PlanarBox box{panels[0].outline.rowwise().minCoeff(), panels[0].outline.rowwise().maxCoeff()};
  for (const SeenPanel& panel : panels) {
    box.low = box.low.cwiseMin(panel.outline.rowwise().minCoeff());
    box.high = box.high.cwiseMax(panel.outline.rowwise().maxCoeff());
  }
  return box;
}

}  // namespace planish
