// SPDX-License-Identifier: MIT
/// The keep-outs' rows of a whole mesh, panel by panel. Built once, O(n). [KEE-1]
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "planish/constraints/keep_out_row.hpp"
#include "planish/constraints/limit_standing.hpp"

namespace planish {

class MeshKeepOuts {
 public:
  /// @param base mesh and points outlive choose_planes()
  MeshKeepOuts(const LimitBase& base, const FreeSpace& free);

  /// The rows that hang on a panel. A point's row hangs on one panel, a box's on its own.
  [[nodiscard]] std::span<const KeepOutRow> of(int face) const {
    const auto begin = static_cast<std::size_t>(first_[static_cast<std::size_t>(face)]);
    return {rows_.data() + begin,
            static_cast<std::size_t>(first_[static_cast<std::size_t>(face) + 1]) - begin};
  }

  /// The points that rest on a keep-out, a plane each.
  [[nodiscard]] std::vector<RestingPoint> resting_points() const;

  /// Whether there are boxes, whose planes may have to be chosen anew.
  [[nodiscard]] bool has_boxes() const { return !boxes_.empty(); }
  /// Other planes between boxes and those of `faces` that are nearer to them by the ones they have
  /// than they need be. @param point as for limit_standing()
  /// @returns whether any changed: the state is then to be solved again
  bool choose_planes(std::span<const int> faces, const std::function<Eigen::Vector3d(int)>& point);
  /// Every plane as in the base again.
  void open();

  /// Whether the barrier acts on a point of `faces`, so that an edit is elsewhere without it.
  [[nodiscard]] bool acts(std::span<const int> faces,
                          const std::function<Eigen::Vector3d(int)>& point) const;

  /// Of `faces`; what it holds back are points. @see limit_standing()
  [[nodiscard]] LimitStanding standing(std::span<const int> faces,
                                       const std::function<Eigen::Vector3d(int)>& point) const;

 private:
  bool choose_plane(std::span<KeepOutRow> rows, const std::function<Eigen::Vector3d(int)>& point);

  const Mesh* mesh_;                              ///< of the base
  const Positions* points_;                       ///< of the base
  std::vector<KeepOutRow> rows_;                  ///< panel by panel
  std::vector<int> first_;                        ///< of each panel, and the end
  std::vector<KeptBox> boxes_;                    ///< in the unit of the points
  std::vector<std::pair<int, KeepOutRow>> base_;  ///< rows with another plane, as they were
};

}  // namespace planish
