// SPDX-License-Identifier: MIT
#include "projection/sound_search.hpp"

#include <utility>
#include <vector>

#include "engines/tangent_newton.hpp"
#include "projection/projection_attempt.hpp"

namespace planish {

/// Projects in growing surroundings of the panels that fail.
SoundProjection SoundSearch::project_around(std::span<const Rung> ladder) const {
  const int everything = task_.mesh.vertex_count();
  std::vector<int> last;
  SoundProjection best;
  for (const int rings : {8, 32, task_.reference != nullptr ? 32 : everything}) {
    std::vector<int> free = surroundings(task_, model_, rings);
    if (free.size() == last.size()) continue;
    SoundProjection next =
        project_soundly(task_.mesh, task_.base, task_.options, free, task_.pins, ladder, progress_);
    const bool cancelled = next.report.status == SolveStatus::kCancelled;
    if (next.is_better_than(best)) best = std::move(next);
    if (cancelled || best.is_flat()) break;
    last = std::move(free);
  }
  return best;
}

/// Keeps the better one; a flat one gives way only to what is half as far.
void SoundSearch::climb(std::span<const Rung> ladder) {
  SoundProjection other = project_around(ladder);
  const SolveCost cost = best_.report.cost + other.report.cost;
  const bool cancelled = other.report.status == SolveStatus::kCancelled;
  const bool stays = best_.is_flat() && !is_half_as_far(other.squared_move);
  if (!stays && other.is_better_than(best_)) best_ = std::move(other);
  if (cancelled) best_.report.status = SolveStatus::kCancelled;
  best_.report.cost = cost;
}

/// The nearest flat mesh, where it is sound as it is and better than what was found.
std::optional<ProjectionResult> SoundSearch::nearest() const {
  ProjectionOptions options = task_.options;
  options.fairness_weight = 0.0;
  const ProjectionTask task{task_.mesh, task_.base, task_.reference, options,
                            task_.pins, task_.kept, task_.adjacency, task_.before};
  ProjectionResult result;
  const Positions after = project_freely(task, progress_, result);
  if (!result.report.usable() || !is_sound(task, after)) return std::nullopt;
  const double squares = result.rms_move * result.rms_move * task.mesh.vertex_count();
  if (best_.is_flat() && !is_half_as_far(squares)) return std::nullopt;
  result.report.cost += best_.report.cost;
  return result;
}

/// Whether points move so far that another mesh may be meant: a strong α_f bends and stretches a
/// panel rather than let its corners move against each other.
bool SoundSearch::goes_far() const {
  constexpr double kFar = 1.0;  // mean edges
  if (!best_.found() || task_.mesh.vertex_count() > kMostFactored) return false;
  const Positions moves = best_.positions - task_.mesh.positions;
  return moves.colwise().norm().maxCoeff() > kFar * mean_edge_length(task_.mesh);
}

ProjectionResult SoundSearch::run() {
  best_ = project_around(kAsked);
  const bool was_asked = task_.reference == nullptr && task_.options.fairness_weight > 0.0;
  const bool looks_on = was_asked ? !is_done() || goes_far() : !is_done() && !best_.is_flat();
  if (looks_on && !is_cancelled()) {
    if (was_asked) {
      if (auto other = nearest()) return std::move(*other);
    }
    climb(kLessFair);
  }
  if (!is_done() && !best_.is_flat()) climb(kFairer);
  return result();
}

/// What was found; with a history, what does not become flat stays as it is: a variation half made
/// exact is of no use.
ProjectionResult SoundSearch::result() {
  ProjectionResult result;
  result.report = std::move(best_.report);
  result.fairness_weight = best_.fairness_weight;
  const bool useful = task_.reference == nullptr ? best_.found() : best_.is_flat();
  Mesh after = task_.mesh;
  if (useful) after.positions = std::move(best_.positions);
  conclude(task_, after.positions, measure_standing(after, task_.adjacency, task_.kept), result);
  return result;
}

}  // namespace planish
