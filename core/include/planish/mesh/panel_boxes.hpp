// SPDX-License-Identifier: MIT
/// Which panels of a mesh are near a box: a tree of boxes, halved along the longest side. Built in
/// O(n log n); a question costs what it finds and the way there.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "planish/mesh/mesh.hpp"

namespace planish {

class PanelBoxes {
 public:
  /// @param points of the mesh, in any unit
  PanelBoxes(const Mesh& mesh, const Positions& points);

  /// The panels whose boxes meet `box`, in no order.
  [[nodiscard]] std::vector<int> near(const Eigen::AlignedBox3d& box) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int begin = 0, end = 0;  ///< of `panels_`
    int second = -1;         ///< the other half; the first stands right behind; −1: no halves
  };

  void halve(int begin, int end);

  std::vector<Eigen::AlignedBox3d> boxes_;  ///< of each panel
  std::vector<int> panels_;
  std::vector<Node> nodes_;
};

}  // namespace planish
