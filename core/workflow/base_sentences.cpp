// SPDX-License-Identifier: MIT
#include "base_sentences.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "planish/measures/metrics.hpp"
#include "planish/text/number.hpp"
#include "report.hpp"

namespace planish::workflow {

std::optional<std::string> planarised_sentence(const FlatBase& base) {
  if (!base.planarised) return std::nullopt;
  return "not flat; planarised first, which moved " +
         std::to_string(base.planarised->moved.size()) + " vertices by up to " +
         three_digits(base.planarised->max_move) + " (units of the mesh)" +
         (base.planarised->report.status == SolveStatus::kIterationLimit
              ? ", not certified to be the best flat mesh near"
              : "");
}

namespace {

/// The sentence that the base was made symmetric first, and by how much.
std::optional<std::string> evened_sentence(const EditRun& run) {
  if (run.evened.max_move == 0.0) return std::nullopt;
  return "not exactly symmetric; made so first, which moved " + std::to_string(run.evened.moved) +
         " vertices by up to " + three_digits(run.evened.max_move) + " (units of the mesh)";
}

/// How many of `points` making the base flat moved, and by how much at most; by 0 where that is
/// rounding.
std::pair<int, double> moved_by_flattening(const EditRun& run, const std::vector<int>& points) {
  int moved = 0;
  double most = 0.0;
  for (const int v : points) {
    const double move = (run.base.mesh.positions.col(v) - run.given.positions.col(v)).norm();
    moved += move > 0.0 ? 1 : 0;
    most = std::max(most, move);
  }
  return {moved, most > kSupportReach * mean_edge_length(run.given) ? most : 0.0};
}

/// The sentence that making the base flat moved what points stand on, and what keeps it in place.
std::optional<std::string> moved_support_sentence(const EditRun& run) {
  if (!run.base.planarised) return std::nullopt;
  double most = 0.0;
  std::string name;
  for (const PointSupport& support : run.supports) {
    if (is_spring(support)) continue;
    const double move = moved_by_flattening(run, points_of(support, run.given)).second;
    if (move <= most) continue;
    most = move;
    name = support_name(support);
  }
  if (most == 0.0) return std::nullopt;
  return "that moved points of " + name + " by up to " + three_digits(most) +
         ", and the edit has them where they are since: planish project --support " + name +
         " makes the file flat with them where they stand";
}

/// The sentence that making the base flat moved the boundary that the edit then keeps.
std::optional<std::string> moved_boundary_sentence(const EditRun& run) {
  if (!run.base.planarised || !run.asked.options.keep_boundary) return std::nullopt;
  const auto [moved, most] = moved_by_flattening(run, boundary_vertices(run.given));
  if (most == 0.0) return std::nullopt;
  return "that moved " + std::to_string(moved) + " points of the boundary by up to " +
         three_digits(most) + ", and --keep-boundary has them where they are since" +
         (run.base.how.keep_shape ? ": planish project --keep-boundary makes the file flat with "
                                    "them where they stand, if they let it"
                                  : "");
}

/// The sentence that no flat mesh near is sound, and what is better than the one that was taken.
std::optional<std::string> spoilt_base_sentence(const EditRun& run) {
  if (!run.base.planarised || run.base.how.keep_shape) return std::nullopt;
  const auto spoilt =
      damage_words(damage_json(run.given, run.given.positions, run.base.mesh.positions));
  if (!spoilt) return std::nullopt;
  const double bent = std::ceil(planarity_summary(run.given).max_excess);
  return "planarising spoilt panels, before any edit: " + *spoilt +
         "; planish project --split 10% makes it flat and sound" +
         (run.asked.options.engine == Engine::kNewton
              ? ", --bound flat=" + three_digits(bent) + " edits it as it is"
              : "");
}

}  // namespace

std::vector<std::string> base_messages(const EditRun& run) {
  return said({planarised_sentence(run.base), moved_support_sentence(run),
               moved_boundary_sentence(run), spoilt_base_sentence(run), evened_sentence(run)});
}

}  // namespace planish::workflow
