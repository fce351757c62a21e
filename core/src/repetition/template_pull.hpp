// SPDX-License-Identifier: MIT
/// Points moved so that every panel comes near a shape given for it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engines/sparse_cholesky.hpp"
#include "planish/constraints/mesh_limits.hpp"
#include "planish/families/families.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/supports/vertex_slides.hpp"

namespace planish {

/// What a panel is to become.
struct PanelGoal {
  FamilyShape corners;  ///< one a corner of the panel, in the panel's order, somewhere in a plane
  double weight = 0.0;  ///< ≥ 0, against 1 of others
};

/// Least squares of all panels' distances from their goals, wherever these lie best, from flat, and
/// from within limits, by Gauss and Newton: what a panel can do as a rigid body costs nothing.
/// [FEW-2]
class TemplatePull {
 public:
  /// @param base in mean edges, outlives this; displacements begin there
  /// @param pins vertices that stay
  /// @param farthest > 0, mean edges: no vertex is let farther, up to what pulls at it
  /// @param limits of `base`, in mean edges; outlive this
  /// @param slides what points stand on, or null; outlives this
  TemplatePull(const Mesh& base, const std::vector<int>& pins, double farthest,
               const MeshLimits& limits, VertexSlides* slides);

  /// A vertex is pulled back to where it began ever more strongly, each time that this is said.
  void hold_back(int vertex);

  /// Takes as many steps as are asked for, fewer once they move nothing.
  /// @param goals one a panel @param displacement 3 × n, mean edges
  /// @returns how many steps were made
  int pull(const std::vector<PanelGoal>& goals, int steps, Eigen::Matrix3Xd& displacement);

 private:
  [[nodiscard]] double step(const std::vector<PanelGoal>& goals, Eigen::Matrix3Xd& displacement);
  void add_panel(const Positions& positions, int f, const PanelGoal& goal);
  void add_limits(const Positions& positions, int f);
  void add_vertex(int v, const Eigen::Vector3d& moved);
  void add_block(int row, int column, const Eigen::Matrix3d& block);
  void keep_to_supports(Eigen::Matrix3Xd& displacement);

  const Mesh& base_;
  double farthest_;
  const MeshLimits& limits_;
  VertexSlides* slides_;
  std::vector<Eigen::Matrix3d> ways_;  ///< n: P of where a vertex may go; 0 for pins
  std::vector<double> stays_;          ///< n: weight of the displacement
  std::vector<int> movable_;           ///< ascending
  SparseCholesky cholesky_;
  Eigen::VectorXd gradient_;
};

}  // namespace planish
