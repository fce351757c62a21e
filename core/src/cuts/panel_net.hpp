// SPDX-License-Identifier: MIT
/// The panels of a mesh while they are cut: who is next to whom stays known.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "cuts/index_rows.hpp"
#include "planish/cuts/cut_mesh.hpp"
#include "planish/mesh/mesh.hpp"

namespace planish {

/// Panels that can get points on their sides, be parted, and go; points that can be added. A panel
/// is its corners in order around it.
class PanelNet {
 public:
  /// @param mesh must have passed check_mesh() and outlive this
  explicit PanelNet(const Mesh& mesh);

  [[nodiscard]] int point_count() const {
    return given_.vertex_count() + static_cast<int>(added_.size());
  }
  [[nodiscard]] int panel_count() const { return corners_.size(); }
  /// Valid until points are added or panels parted.
  [[nodiscard]] std::span<const int> panel(int f) const { return corners_[f]; }
  [[nodiscard]] Eigen::Vector3d point(int v) const;

  /// Twice the area of panel f, along its normal.
  [[nodiscard]] Eigen::Vector3d area_vector(int f) const;

  /// Where `vertex` is among the corners of panel f; -1 if it is none.
  [[nodiscard]] int corner_of(int f, int vertex) const;
  [[nodiscard]] bool has_side(int f, int from, int to) const;

  /// The panels with that side: none, one or two, -1 behind them.
  [[nodiscard]] std::array<int, 2> panels_at(int from, int to) const;

  /// Puts a new point on the edge, at a share of the way: all panels there get it as a corner.
  int add_on_edge(int from, int to, double share);
  int add_inside(int f, const Eigen::Vector3d& place);

  /// Gives panel f the first of `parts` and appends the others.
  void part(int f, const std::vector<std::vector<int>>& parts);

  /// The panels that are not in `gone` (one a panel), their numbers closed up.
  void remove(const std::vector<char>& gone);

  /// Starts the record of a cut, which ends where the next one starts.
  void start(const Cut& cut);

  /// Panels that got points on their sides since start(), and were not parted since; and the
  /// points.
  [[nodiscard]] std::vector<int> panels_with_new_points() const;
  [[nodiscard]] bool is_new(int v) const { return v >= first_new_point_; }
  [[nodiscard]] std::vector<int> new_points_of(int f) const;

  [[nodiscard]] CutMesh finished() const;

 private:
  /// The side of panel f's parent that the edge, one of f's sides, lies on; -1, -1 where it is
  /// inside.
  [[nodiscard]] std::array<int, 2> given_side(int from, int to, int f) const;

  /// Whether the last cut parted panel f or made it.
  [[nodiscard]] bool is_parted(int f) const {
    return parted_in_[static_cast<std::size_t>(f)] == records_.size();
  }
  int add_point(const Eigen::Vector3d& place, const AddedPoint& where);
  void add_panel_at(int v, int f);
  void take_from_corners(int f);
  void add_to_corners(int f);

  const Mesh& given_;
  std::vector<Eigen::Vector3d> places_;  ///< of added points
  std::vector<AddedPoint> added_;
  IndexRows corners_;                   ///< one row a panel
  IndexRows panels_of_;                 ///< one row a point
  std::vector<int> parents_, groups_;   ///< one a panel; group -1: of none
  std::vector<std::size_t> parted_in_;  ///< one a panel: by which cut last, from 1; 0: by none
  std::vector<CutRecord> records_;
  int first_new_point_ = 0;  ///< of the last cut
};

}  // namespace planish
