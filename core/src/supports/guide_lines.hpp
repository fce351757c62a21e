// SPDX-License-Identifier: MIT
/// The polygons that points slide along: the boundary as it is drawn, and lines of the mesh.
/// [SUP-3]
#pragma once

#include <vector>

#include "planish/mesh/mesh.hpp"
#include "planish/supports/point_support.hpp"

namespace planish {

/// Who comes before and after a vertex on its line; O(n) once.
class GuideLines {
 public:
  /// @param supports those that are no lines are passed over; they must have no problem
  GuideLines(const Mesh& mesh, const std::vector<PointSupport>& supports);

  /// The vertex after `vertex` where `side` is 1, before it where it is 0; −1 where the line ends
  /// or branches there.
  [[nodiscard]] int beside(int vertex, int side) const;
  /// Whether no point passes `vertex`: the line turns by 30° or more there, ends or branches.
  [[nodiscard]] bool is_corner(int vertex) const;

 private:
  void add_boundary();
  void add_polyline(const std::vector<int>& vertices);
  /// What stands on another line as well has nowhere to go where this one ends.
  void end_polyline(const std::vector<int>& vertices);

  const Mesh& mesh_;
  std::vector<int> before_, after_;  ///< n; −1 where there is none
};

}  // namespace planish
