// SPDX-License-Identifier: MIT
/// Frames of a drag under its limit, and how far a pull gets.
#include <utility>

#include "planish/edit/how_far.hpp"
#include "planish/numeric/stopwatch.hpp"
#include "session.hpp"

namespace planish {
namespace {

/// How long a drag may wait for its limit.
constexpr double kSearchSeconds = 2.0;
/// Frames more that one takes where its time is over before anything holds it back: else a pointer
/// that stands would say nothing.
constexpr int kCatchingUp = 6;

}  // namespace

EditStanding Session::standing() const {
  const ShapeReport& shown = shape_report_;
  return {.status = shown.solve.status,
          .moved_vertices = shown.moved_vertices,
          .handle_error = shown.handle_error,
          .fold_growth = shown.fold_growth,
          .is_bound = is_bound(shown.solve)};
}

PullStanding Session::pull_standing(const PullLimit& limit,
                                    const std::vector<Handle>& handles) const {
  const double way = farthest_handle(handles, base_.positions);
  const EditStanding edit = standing();
  return {is_stuck(edit), edit.is_bound, arrives(limit, way, edit), lags(limit, way, edit)};
}

Refusal Session::follow(const EditTargets& targets, double budget_seconds, const PullLimit& limit) {
  const double way = farthest_handle(targets.handles, base_.positions);
  Refusal refusal = edit(EditMode::kDrag, targets, budget_seconds);
  for (int k = 0; k < kCatchingUp && !refusal && lags(limit, way, standing()); ++k) {
    refusal = edit(EditMode::kDrag, targets, budget_seconds);
  }
  return refusal;
}

/// A pull that was held back and goes no further: what it is held at settles.
Refusal Session::rest(EditTargets targets, double budget_seconds, const PullLimit& limit) {
  pulled_.taken = pull_hold_.taken();
  if (shape_report_.solve.status != SolveStatus::kIterationLimit) return std::nullopt;
  targets.handles = pull_hold_.taken();
  if (Refusal refusal = edit(EditMode::kDrag, targets, budget_seconds)) return refusal;
  if (pull_standing(limit, targets.handles).arrives) {
    keep_edit();
  } else {
    show_kept();
  }
  return std::nullopt;
}

Refusal Session::hold(const EditTargets& targets, double budget_seconds, const PullLimit& limit) {
  if (shows_held_ && pull_hold_.held_back_from(targets.handles)) {
    return rest(targets, budget_seconds, limit);
  }
  EditTargets tried = targets;
  Refusal refusal;
  const PullFrames frames{
      .edit = [&](const std::vector<Handle>& handles, bool settled) -> std::optional<bool> {
        if (settled) go_back();
        shows_held_ = false;
        tried.handles = handles;
        refusal = follow(tried, budget_seconds, limit);
        if (refusal) return std::nullopt;
        return pull_standing(limit, handles).arrives;
      },
      .keep =
          [&] {
            keep_edit();
            shows_held_ = true;
          },
      .back =
          [&] {
            show_kept();
            shows_held_ = true;
          }};
  const Stopwatch watch;
  const auto arrived = pull_hold_.take(limit.from, targets.handles, frames,
                                       [&] { return watch.seconds() >= kSearchSeconds; });
  if (arrived == false) pulled_.taken = pull_hold_.taken();
  return refusal;
}

Refusal Session::go_furthest(EditMode first, const EditTargets& targets, double budget_seconds,
                             const PullLimit& limit) {
  const double length = longest_way(limit.from, targets.handles);
  EditTargets tried = targets;
  Refusal refusal;
  const Puller puller{.edit = [&](double share) -> std::optional<Arrival> {
                        tried.handles = between(limit.from, targets.handles, share);
                        refusal =
                            edit(share == 1.0 ? first : EditMode::kSolve, tried, budget_seconds);
                        if (refusal) return std::nullopt;
                        const double way = farthest_handle(tried.handles, base_.positions);
                        return arrival_of(limit, way, length, standing());
                      },
                      .keep = [&] { keep_edit(); },
                      .back = [&] { show_kept(); }};
  const std::optional<double> share = furthest(puller, limit.tries);
  if (share && *share != 1.0) pulled_.taken = between(limit.from, targets.handles, *share);
  return refusal;
}

Refusal Session::pull(PullWay way, const EditTargets& targets, double budget_seconds,
                      const PullLimit& limit) {
  pulled_ = {};
  if (way == PullWay::kHold) return hold(targets, budget_seconds, limit);
  if (way == PullWay::kRelease || way == PullWay::kFurthest) {
    const EditMode first = way == PullWay::kRelease ? EditMode::kRelease : EditMode::kSolve;
    return go_furthest(first, targets, budget_seconds, limit);
  }
  Refusal refusal = follow(targets, budget_seconds, limit);
  if (refusal || way == PullWay::kFollow) return refusal;
  const double longest = farthest_handle(targets.handles, base_.positions);
  pulled_.suffices = suffices(standing(), longest, kNoticeable);
  if (pulled_.suffices) {
    keep_edit();
  } else {
    show_kept();
  }
  return std::nullopt;
}

}  // namespace planish
