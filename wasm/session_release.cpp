// SPDX-License-Identifier: MIT
/// The end of a drag: a design that depends on its recipe alone, and that is what was shown; and
/// edits that are kept while others are tried.
#include <algorithm>

#include "session.hpp"

namespace planish {
namespace {

/// Of the largest pull: what a release may differ by from what the drag showed.
constexpr double kAsShown = 0.01;
/// For the frame at the end, if it was not shown: longer than any takes.
constexpr double kFrameSeconds = 10.0;
/// Steps of a continuation that a release tries.
constexpr int kPaths[] = {8, 16, 32};
/// Of the objective: less is not lower.
constexpr double kLower = 1e-3;

/// Where `shape` has a vertex.
Eigen::Vector3d place_in(const Mesh& base, const SparseShape& shape, int vertex) {
  const auto found = std::lower_bound(shape.moved.begin(), shape.moved.end(), vertex);
  if (found == shape.moved.end() || *found != vertex) return base.positions.col(vertex);
  return shape.positions.col(found - shape.moved.begin());
}

/// Whether two shapes are the same one as far as eyes can tell, for an edit of `targets`.
bool look_alike(const Mesh& base, const EditTargets& targets, const SparseShape& a,
                const SparseShape& b) {
  double pull = 0.0;
  for (const auto& [vertex, target] : targets.handles) {
    pull = std::max(pull, (target - base.positions.col(vertex)).norm());
  }
  const auto near = [&](int v) {
    return (place_in(base, a, v) - place_in(base, b, v)).norm() <= kAsShown * pull;
  };
  return std::all_of(a.moved.begin(), a.moved.end(), near) &&
         std::all_of(b.moved.begin(), b.moved.end(), near);
}

}  // namespace

/// The first of the solves at once and by continuation that ends where the drag does at these
/// targets, which its last frame need not have shown; the one at once where none does, or without a
/// drag.
HandleEditResult Session::release(EditTargets& targets) {
  targets.continuation = 0;
  HandleEditResult at_once = solver_->solve(targets, progress_);
  if (!follows_path_ || options_.engine != Engine::kNewton || !at_once.report.usable()) {
    return at_once;
  }
  SparseShape shown{moved_, moved_positions()};
  if (targets.handles != targets_.handles) {
    const HandleEditResult frame = solver_->drag(targets, kFrameSeconds);
    shown = {frame.moved, frame.moved_positions};
  }
  const auto is_shown = [&](const HandleEditResult& result) {
    return look_alike(base_, targets, shown, {result.moved, result.moved_positions});
  };
  if (is_shown(at_once)) return at_once;
  for (const int steps : kPaths) {
    targets.continuation = steps;
    HandleEditResult along = solver_->solve(targets, progress_);
    if (along.report.status == SolveStatus::kCancelled) return along;
    if (!along.report.usable() || !is_shown(along)) continue;
    const double lower = (1.0 - kLower) * along.report.objective.total();
    lower_at_once_ = at_once.report.objective.total() < lower;
    return along;
  }
  targets.continuation = 0;
  return at_once;
}

void Session::keep_edit() {
  if (solver_) solver_->keep_frame();
  kept_ = {targets_, {moved_, moved_positions()}, shape_report_, follows_path_};
}

void Session::go_back() {
  if (solver_) solver_->go_back();
}

void Session::show_kept() {
  if (!kept_) return;
  go_back();
  targets_ = kept_->targets;
  show(kept_->shape.moved, kept_->shape.positions);
  follows_path_ = kept_->follows_path;
  shape_report_ = kept_->report;
}

}  // namespace planish
