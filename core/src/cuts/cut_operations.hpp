// SPDX-License-Identifier: MIT
/// What each cut does to the panels. Where one is refused the net is worth nothing any more.
#pragma once

#include "cuts/panel_net.hpp"
#include "planish/cuts/cut.hpp"
#include "planish/text/refusal.hpp"

namespace planish {

[[nodiscard]] Refusal apply_cut(const SplitCut& cut, PanelNet& net);
[[nodiscard]] Refusal apply_cut(const StripCut& cut, PanelNet& net);
[[nodiscard]] Refusal apply_cut(const CornerCut& cut, PanelNet& net);
[[nodiscard]] Refusal apply_cut(const RefineCut& cut, PanelNet& net);
[[nodiscard]] Refusal apply_cut(const TrimCut& cut, PanelNet& net);

/// A sentence if there is no panel of number `f`.
[[nodiscard]] Refusal find_problem_of_panel(const PanelNet& net, int f);

}  // namespace planish
