// SPDX-License-Identifier: MIT
/// The edit of a session's base that makes few panels again.
#include <utility>

#include "planish/numeric/stopwatch.hpp"
#include "refused_outcome.hpp"
#include "session.hpp"

namespace planish {

Refusal Session::fewest(EditTargets targets, const FewestOptions& asked) {
  if (const Refusal refusal = begin_edit(targets)) return refusal;
  if (const auto problem = find_problem(asked, options_, targets)) {
    return "Few panels: " + *problem + ".";
  }
  const DesignSteps steps = steps_of(targets);
  if (Refusal refusal = find_image_problem(steps)) return refusal;
  const Stopwatch watch;
  BuildableFewest found =
      find_buildable_fewest(base_, options_, steps.images(), asked, symmetry_.get(), progress_);
  const HandleEditResult& result = found.edit.result;
  const std::vector<int>& held = found.edit.held;
  if (const Refusal refusal = unusable(result.report, "The edit")) return refusal;
  family_.reset();
  lower_at_once_ = false;
  options_ = found.options;
  renew_solver();
  targets_ = std::move(targets);
  targets_.pins.insert(targets_.pins.end(), held.begin(), held.end());
  show(result.moved, result.moved_positions);
  renew_report(result.report, watch.seconds());
  fewest_found_ = std::move(found);
  return std::nullopt;
}

}  // namespace planish
