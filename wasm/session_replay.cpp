// SPDX-License-Identifier: MIT
/// Doing a recorded design again: the core replays it, the session shows what that gave.
#include <utility>
#include <variant>

#include "planish/numeric/stopwatch.hpp"
#include "refused_outcome.hpp"
#include "session.hpp"

namespace planish {
namespace {

Refusal stopped(const Replay& replay) {
  if (auto refusal = unusable(replay.report, replay.exact ? "The projection" : "The edit")) {
    return refusal;
  }
  const bool nowhere = !replay.directions.empty() && replay.directions.back() == 0;
  return nowhere ? Refusal("No variation was found around this edit.") : std::nullopt;
}

}  // namespace

Refusal Session::replay(Design design, std::optional<std::uint32_t> base_hash) {
  if (base_hash && *base_hash != mesh_hash(uncut())) {
    return "The mesh in the design is not the one that was edited (source.hash differs).";
  }
  if (design.cuts != (cut_ ? cut_->cuts : std::vector<Cut>())) {
    return "The design has other cuts.";
  }
  if (symmetry_ && design.symmetry != symmetry_->elements) {
    return "The design has another symmetry.";
  }
  std::vector<PointSupport> stated = design.targets.supports;
  design.targets.supports = with_added_points(stated);
  const Stopwatch watch;
  auto result = replay_on(base_, symmetry_, design, progress_);
  if (auto* sentence = std::get_if<std::string>(&result)) return as_sentence(std::move(*sentence));
  auto& done = std::get<Replay>(result);
  if (Refusal refusal = stopped(done)) return refusal;
  options_ = std::move(design.options);
  stated_supports_ = std::move(stated);
  supports_ = design.targets.supports;
  targets_ = std::move(design.targets);
  // On a base without an edit they were not looked at.
  supports_fit_ = supports_.empty() || !targets_.handles.empty();
  constraints_fit_ = options_.constraints.empty() || !targets_.handles.empty();
  renew_solver();
  lower_at_once_ = false;
  replayed_ = {.directions = done.directions, .centre = {}, .deviation = done.deviation};
  if (done.family) replayed_.centre = difference(base_, done.family->centre);
  family_ = std::move(done.family);
  const SparseShape shape = difference(base_, done.shape);
  show(shape.moved, shape.positions);
  renew_report(std::move(done.exact ? *done.exact : done.report), watch.seconds());
  return std::nullopt;
}

}  // namespace planish
