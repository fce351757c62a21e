// SPDX-License-Identifier: MIT
/// Where a picture of the structure is seen from.
#pragma once

#include <Eigen/Core>
#include <span>

#include "planish/fabrication/flat_panel.hpp"

namespace planish {

struct ViewAxes {
  Eigen::Vector3d right, up, towards;  ///< unit, right-handed; `towards` points at the viewer

  [[nodiscard]] Eigen::Vector2d seen(const Eigen::Vector3d& p) const {
    return {right.dot(p), up.dot(p)};
  }
};

/// Axes of a view with z up; with y up where one looks along z.
[[nodiscard]] ViewAxes view_from(const Eigen::Vector3d& towards);

struct SeenPanel {
  int face = 0;
  double depth = 0.0;  ///< of its mean corner, towards the viewer
  Outline outline;
};

[[nodiscard]] SeenPanel see_panel(const Mesh& mesh, int face, const ViewAxes& view);

/// The farthest first, so that what is nearer is painted over it.
void sort_by_depth(std::vector<SeenPanel>& panels);

/// What lies within two corners.
struct PlanarBox {
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
};

[[nodiscard]] PlanarBox box_of(std::span<const SeenPanel> panels);

}  // namespace planish
