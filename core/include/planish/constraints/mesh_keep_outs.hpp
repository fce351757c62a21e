// SPDX-License-Identifier: MIT
/// The keep-outs' rows of a whole mesh, panel by panel. Built once, O(n). [KEE-1]
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "planish/constraints/keep_out_row.hpp"
#include "planish/constraints/limit_standing.hpp"
#include "planish/constraints/panel_contact.hpp"
#include "planish/mesh/panel_boxes.hpp"

namespace planish {

class MeshKeepOuts {
 public:
  /// @param base whose mesh, adjacency and points outlive this
  MeshKeepOuts(const LimitBase& base, const FreeSpace& free);

  /// The rows that hang on a panel. A point's row hangs on one panel, a box's on its own.
  [[nodiscard]] std::span<const KeepOutRow> of(int face) const {
    return rows_[static_cast<std::size_t>(face)];
  }

  /// The points that rest on a keep-out, a plane each.
  [[nodiscard]] std::vector<RestingPoint> resting_points() const;

  /// Whether there may be planes that have to be chosen anew.
  [[nodiscard]] bool has_turning_planes() const { return !boxes_.empty() || !pairs_.empty(); }
  /// Whether there are any rows: a mesh that is a keep-out itself may have none.
  [[nodiscard]] bool has_rows() const { return has_sides_ || has_turning_planes(); }
  /// Other planes between boxes and those of `faces`, and between two panels, that are nearer by
  /// the ones they have than they need be. @param point as for limit_standing()
  /// @returns whether any changed: the state is then to be solved again
  bool choose_planes(std::span<const int> faces, const std::function<Eigen::Vector3d(int)>& point);
  /// Every plane as in the base again.
  void open();

  /// Planes between those of `faces` and what they may have gone through since the base: panels
  /// with which they share no point, where the mesh is a keep-out itself [KEE-4], and walls, which
  /// are panels of other models [KEE-5].
  /// @returns whether a new one acts: the edit is then to be made again from the base
  bool part_panels(std::span<const int> faces, const std::function<Eigen::Vector3d(int)>& point);
  /// Drops the planes that part_panels() made.
  void forget_parted();

  /// How `faces` stand to the keep-outs; what is held back are points. @see limit_standing()
  [[nodiscard]] LimitStanding standing(std::span<const int> faces,
                                       const std::function<Eigen::Vector3d(int)>& point) const;

 private:
  /// Two panels that share no point, and a plane between them. Each has a row a corner, but a wall:
  /// it does not move, and the other has all the room.
  struct Pair {
    std::array<int, 2> panels;             ///< the second may be a wall, see is_wall()
    std::array<std::size_t, 2> first_row;  ///< among the rows of each
  };

  /// A panel that an edit touched, on its way from the base.
  struct Touched {
    int face;
    PanelPath path;
    Eigen::AlignedBox3d box;  ///< of both ends, and the clearance
  };

  bool choose_plane(std::span<KeepOutRow> rows, const std::function<Eigen::Vector3d(int)>& point);
  bool choose_plane(const Pair& pair, const std::function<Eigen::Vector3d(int)>& point);
  void turn_plane(const Pair& pair, const PanelGap& gap, double part,
                  const std::array<double, 2>& side);
  void take(int face, std::size_t row, const KeepOutRow& other);
  void take_walls(const FreeSpace& free);
  /// Walls are counted behind the faces of the mesh.
  [[nodiscard]] bool is_wall(int panel) const { return panel >= base_.mesh.face_count(); }
  [[nodiscard]] bool parts_panels() const { return reach_ != nullptr || wall_reach_ != nullptr; }
  [[nodiscard]] std::vector<int> panels_near(const Eigen::AlignedBox3d& box) const;
  [[nodiscard]] double part_of_first(const Pair& pair, const std::array<bool, 2>& moved) const;
  void part_what_touches();
  void add_pair(int first, int second);
  [[nodiscard]] bool may_meet(int first, int second) const;
  [[nodiscard]] std::span<KeepOutRow> rows_of(const Pair& pair, std::size_t which);
  [[nodiscard]] std::vector<Touched> touched_panels(
      std::span<const int> faces, const std::function<Eigen::Vector3d(int)>& point) const;
  void part_from_all(const std::vector<Touched>& touched, std::size_t k);
  [[nodiscard]] Positions base_shape(int face) const;
  [[nodiscard]] Positions shape(int face, const std::function<Eigen::Vector3d(int)>& point) const;

  /// A row with another plane, as it was.
  struct BaseRow {
    int face;
    std::size_t row;
    KeepOutRow was;
  };

  LimitBase base_;
  std::vector<std::vector<KeepOutRow>> rows_;  ///< of each panel: half-spaces, boxes, pairs
  bool has_sides_;                             ///< half-spaces
  std::vector<KeptBox> boxes_;                 ///< in the unit of the points
  std::vector<BaseRow> changed_;
  std::shared_ptr<const PanelBoxes> reach_;       ///< null: the mesh is no keep-out itself
  Mesh walls_;                                    ///< in the unit and the place of the points
  std::shared_ptr<const PanelBoxes> wall_reach_;  ///< null: there are none
  double clearance_ = 0.0;                        ///< between panels; unit of the points
  std::vector<Pair> pairs_;
  std::vector<std::vector<int>> pairs_of_;  ///< of each panel, into `pairs_`
  std::size_t base_pairs_ = 0;              ///< that touch in the base
};

}  // namespace planish
