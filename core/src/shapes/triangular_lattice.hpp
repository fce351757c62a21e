// SPDX-License-Identifier: MIT
/// A patch of the triangular lattice: its points, edges and triangles as integers.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

namespace planish {

/// Height of the lattice's triangles over their side: √3 / 2.
inline constexpr double kHalfRoot3 = 0.86602540378443864676;

/// A lattice point in steps along the two axes, which are 60° apart.
struct LatticePoint {
  int i = 0, j = 0;
};

/// One of the things that belong to `owner`: triangles 0 (to the right of 60°) and 1 (to the
/// left), or edges 0, 1, 2 that leave at 0°, 60° and 120°.
struct LatticeCell {
  LatticePoint owner;
  int kind = 0;
};

/// The points of a lattice that lie in a plane region around the origin.
class LatticePatch {
 public:
  /// @param spacing distance of neighbouring points, > 0
  /// @param reach no point farther than this from the origin is asked for
  /// @param inside whether a point of the plane belongs to the region; the origin always does
  LatticePatch(double spacing, double reach,
               const std::function<bool(const Eigen::Vector2d&)>& inside);

  /// The points, row by row.
  [[nodiscard]] std::vector<LatticePoint> points() const;
  [[nodiscard]] bool contains(LatticePoint point) const;
  [[nodiscard]] Eigen::Vector2d position(LatticePoint point) const;

  /// A number below cell_limit() that is unique among cells of the same sort around the patch.
  [[nodiscard]] std::size_t index(LatticeCell cell) const;
  [[nodiscard]] std::size_t cell_limit() const { return 3 * inside_.size(); }

 private:
  [[nodiscard]] std::size_t slot(LatticePoint point) const;
  void remove_outliers();

  double spacing_;
  int radius_;  ///< largest |i| and |j| of a point, plus 2 for the cells around
  std::vector<char> inside_;
};

/// The six triangles around `point`, counter-clockwise from the one above 0°.
[[nodiscard]] std::array<LatticeCell, 6> triangles_around(LatticePoint point);

/// The six edges around `point`, counter-clockwise from 0°.
[[nodiscard]] std::array<LatticeCell, 6> edges_around(LatticePoint point);

/// Corners of a triangle, counter-clockwise.
[[nodiscard]] std::array<LatticePoint, 3> triangle_corners(LatticeCell triangle);

/// Edges of a triangle, counter-clockwise.
[[nodiscard]] std::array<LatticeCell, 3> triangle_edges(LatticeCell triangle);

/// Both ends of an edge, the owner first.
[[nodiscard]] std::array<LatticePoint, 2> edge_ends(LatticeCell edge);

}  // namespace planish
