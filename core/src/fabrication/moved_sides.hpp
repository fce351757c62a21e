// SPDX-License-Identifier: MIT
/// The sides of a panel moved inwards: where they meet, to the last digits, from a part that the
/// grid left of them.
#pragma once

#include <vector>

#include "fabrication/outline_side.hpp"
#include "planish/fabrication/inset.hpp"

namespace planish {

class MovedSides {
 public:
  /// @param step of the grid
  MovedSides(const std::vector<OutlineSide>& sides, double distance, double step)
      : sides_(sides), distance_(distance), step_(step) {}

  /// The corners of `rough`, a part that is left on the grid `deeper` below the moved sides, where
  /// those sides themselves meet.
  [[nodiscard]] CutPiece corners(const Outline& rough, double deeper) const;

 private:
  /// What the grid rounds by, and its sides lean by.
  [[nodiscard]] double near() const { return 4.0 * step_; }
  [[nodiscard]] double depth(const OutlineSide& side, const Eigen::Vector2d& p) const;
  [[nodiscard]] bool runs_along(const OutlineSide& side, const OutlineSide& rough,
                                double deeper) const;
  [[nodiscard]] int along_which(const OutlineSide& rough, double deeper) const;
  [[nodiscard]] std::vector<OutlineSide> lines_of(const Outline& rough, double deeper) const;
  void divide(const OutlineSide& line, double deeper, std::vector<OutlineSide>& parts) const;
  [[nodiscard]] bool are_parallel(int a, int b) const;
  [[nodiscard]] Eigen::Vector2d meeting(const OutlineSide& in, const OutlineSide& out,
                                        double deeper) const;

  const std::vector<OutlineSide>& sides_;
  double distance_, step_;
};

}  // namespace planish
