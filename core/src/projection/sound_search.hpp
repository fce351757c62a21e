// SPDX-License-Identifier: MIT
/// A flat mesh with every panel's shape kept, looked for by one attempt after the other.
#pragma once

#include <optional>
#include <span>

#include "projection/projection_task.hpp"
#include "projection/sound_projection.hpp"

namespace planish {

/// As fair as asked for, with every panel's shape kept. Where that is not flat, sound and
/// certified, or far away, the nearest flat mesh if it is sound; then less fair, which asks less of
/// a panel that folds or tips over; then, for panels that are not flat yet, fairer, since a smooth
/// displacement seldom folds one.
class SoundSearch {
 public:
  SoundSearch(const ProjectionTask& task, const Progress& progress)
      : task_(task), progress_(progress), model_(task.mesh, task.options.fairness) {}

  [[nodiscard]] ProjectionResult run();

 private:
  static constexpr Rung kAsked[] = {{1.0, false}, {1.0, true}};
  static constexpr Rung kLessFair[] = {{0.1, false}, {0.1, true}};
  static constexpr Rung kFairer[] = {{10.0, true}, {100.0, true}};

  [[nodiscard]] SoundProjection project_around(std::span<const Rung> ladder) const;
  void climb(std::span<const Rung> ladder);
  [[nodiscard]] std::optional<ProjectionResult> nearest() const;
  [[nodiscard]] bool is_done() const {
    return is_cancelled() || best_.ends_search(task_.mesh.vertex_count());
  }
  [[nodiscard]] bool is_cancelled() const { return best_.report.status == SolveStatus::kCancelled; }
  [[nodiscard]] bool goes_far() const;
  [[nodiscard]] bool is_half_as_far(double squared_move) const {
    return squared_move < 0.25 * best_.squared_move;
  }
  [[nodiscard]] ProjectionResult result();

  const ProjectionTask& task_;
  const Progress& progress_;
  MeshModel model_;  ///< whose rings are counted
  SoundProjection best_;
};

}  // namespace planish
