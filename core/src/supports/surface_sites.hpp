// SPDX-License-Identifier: MIT
/// The smooth surface that the points of a model stand for: paraboloids at them, mixed. [SUP-4]
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planish/mesh/adjacency.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// A function of places that is zero on a surface and rises by the distance from it, near it.
struct SurfaceHeight {
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();  ///< ∂²value
};

/// Panels that meet at less than 30° are one side of the model, each side a surface of its own:
/// what is flat stays flat and what is sharp stays sharp. A side has a site at each of its points:
/// the paraboloid that fits the points around best, through the point itself. Between sites their
/// functions are mixed with weights that are twice differentiable, as partition-of-unity implicits
/// are (Ohtake et al. 2003).
class SurfaceSites {
 public:
  explicit SurfaceSites(const Mesh& mesh);

  /// The side that a panel is part of.
  [[nodiscard]] int side(int panel) const { return sides_[static_cast<std::size_t>(panel)]; }

  /// The function of the side that `panel` is part of. @param place near that panel
  [[nodiscard]] SurfaceHeight height(int panel, const Eigen::Vector3d& place) const;

 private:
  struct Site {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    double reach = 1.0;  ///< where its weight ends
    Eigen::Vector3d slope = Eigen::Vector3d::UnitZ();
    Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();
  };
  struct Sum;

  void place_sites(const Mesh& mesh);
  void join_sites();
  [[nodiscard]] std::vector<int> around(int site) const;
  void fit(int number, const Eigen::Vector3d& normal);
  static void add(const Site& site, const Eigen::Vector3d& place, Sum& sum);

  std::vector<int> sides_;  ///< of each panel
  std::vector<Site> sites_;
  RaggedRows corners_;     ///< of each panel, its corners' sites
  RaggedRows neighbours_;  ///< of each site, ascending: those that share a panel with it
};

}  // namespace planish
